/** An element with attributes and what stands in it; texts stay texts. */
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name, attributes: Record<string, string> = {}, ...content: (Node | string)[]
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...content);
  return made;
}

export function button(text: string, pressed: () => void, look = ""): HTMLButtonElement {
  const made = element("button", { type: "button", class: `button ${look}` }, text);
  made.addEventListener("click", pressed);
  return made;
}

export const paragraphs = (texts: string[]): HTMLElement[] =>
  texts.map((text) => element("p", {}, text));

/** A heading that is focused when its page appears, so that readers begin there. */
export function heading(text: string): HTMLHeadingElement {
  return element("h1", { tabindex: "-1" }, text);
}
