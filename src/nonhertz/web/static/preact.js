// The library that the form is drawn with, in one place.

export { html, render, useRef, useState } from "./vendor/preact-htm.js";
