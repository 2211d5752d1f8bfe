// Elements of the page by their names.
export const by_id = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;
