// Browsers forbid pages that were opened from disk to read each other. The search then takes what
// stands around its results from page_texts.js instead.
if (location.protocol === "file:") {
  const site = new URL(".", location.href).pathname;
  window.fetch = async (address) => {
    const page = new URL(address, location.href).pathname.slice(site.length);
    const main = document.createElement("div");
    main.setAttribute("role", "main");
    main.textContent = pageTexts[page];
    return { text: async () => main.outerHTML };
  };
}
