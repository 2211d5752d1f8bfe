// Light and dark: as the system says, unless the reader of the page chooses.

const SYSTEM = matchMedia("(prefers-color-scheme: dark)");
const listeners: (() => void)[] = [];
const changed = () => listeners.forEach((act) => act());
SYSTEM.addEventListener("change", changed);

export function is_dark(): boolean {
  const chosen = document.documentElement.dataset.theme;
  return chosen === undefined ? SYSTEM.matches : chosen === "dark";
}

/// @param theme  light, dark; anything else: as the system says
export function choose_theme(theme: string): void {
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
  else delete document.documentElement.dataset.theme;
  changed();
}

export function on_theme(act: () => void): void {
  listeners.push(act);
}
