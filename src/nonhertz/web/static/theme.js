// Sets light or dark before anything is drawn: a classic script, because modules are deferred.
// Without a choice by the user the page follows the system; if storage is denied, the choice lasts as long as the page.
"use strict";
(() => {
  const [root, name] = [document.documentElement, "nonhertz-theme"];
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const stored = (act) => {
    try {
      return act();
    } catch {
      return null;
    }
  };
  const show = (theme) => {
    root.dataset.theme = theme;
    const button = document.getElementById("theme");
    if (!button) return;
    const other = theme === "dark" ? "Light" : "Dark";
    button.textContent = other;
    button.setAttribute("aria-label", `${other} colours`);
    button.onclick = () => {
      stored(() => localStorage.setItem(name, other.toLowerCase()));
      show(other.toLowerCase());
    };
  };
  const current = () => show(stored(() => localStorage.getItem(name)) ?? (system.matches ? "dark" : "light"));
  current();
  system.addEventListener("change", current);
  document.addEventListener("DOMContentLoaded", current);
})();
