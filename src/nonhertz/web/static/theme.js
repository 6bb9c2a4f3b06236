// Sets light or dark before anything is drawn: a classic script, because modules are deferred.
// Without a choice by the user the page follows the system; if storage is denied, the choice is not remembered.
"use strict";
(() => {
  const root = document.documentElement;
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const kept = () => {
    try {
      return localStorage.getItem("nonhertz-theme");
    } catch {
      return null;
    }
  };
  const show = (theme) => {
    root.dataset.theme = theme;
    const button = document.getElementById("theme");
    if (button) button.textContent = theme === "dark" ? "Light" : "Dark";
    if (button) button.setAttribute("aria-label", theme === "dark" ? "Light colours" : "Dark colours");
  };
  const current = () => kept() ?? (system.matches ? "dark" : "light");
  show(current());
  system.addEventListener("change", () => show(current()));
  document.addEventListener("DOMContentLoaded", () => {
    show(current());
    document.getElementById("theme")?.addEventListener("click", () => {
      const other = root.dataset.theme === "dark" ? "light" : "dark";
      try {
        localStorage.setItem("nonhertz-theme", other);
      } catch {
        // Storage is denied: the choice lasts only as long as the page.
      }
      show(other);
    });
  });
})();
