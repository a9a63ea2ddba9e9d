// A studio in a browser, as tests of it need it.
import { join } from "node:path";
import { openBrowser } from "../questionnaire/participant.mjs";

const sizes = [{ width: 1366, height: 768 }, { width: 1920, height: 1080 }];

/**
 * Opens the studio at a link: its page, what the browser complains of, and hands to use it with.
 * MIEN_PICTURES: a folder for screenshots.
 */
export async function openStudio(link) {
  const browser = await openBrowser();
  const page = await (await browser.newContext({ viewport: sizes[0] })).newPage();
  page.setDefaultTimeout(120000); // of busy machines that draw without a graphics card
  const wrong = [];
  page.on("pageerror", (error) => wrong.push(String(error)));
  page.on("console", (message) => message.type() === "error" && wrong.push(message.text()));

  const tab = (name) => page.getByRole("tab", { name, exact: true }).click();
  const number = (name) => page.getByRole("spinbutton", { name: `${name}, number` });

  /** The motion is that of what the page shows. */
  const settled = () => page.waitForFunction(() => {
    const { studio } = globalThis.studio ?? {};
    return studio?.made && !studio.isMaking;
  }, null, { timeout: 60000 });

  async function set(name, value) {
    await number(name).fill(String(value));
    await number(name).press("Enter");
    await settled();
  }

  async function pictures(name) {
    if (!process.env.MIEN_PICTURES) return;
    for (const size of sizes) {
      await page.setViewportSize(size);
      await page.evaluate(async () => {
        globalThis.studio.stage.seek(0.2);
        await globalThis.studio.stage.drawn();
        await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      });
      await page.screenshot({ path: join(process.env.MIEN_PICTURES, `${name}-${size.width}.png`) });
    }
    await page.setViewportSize(sizes[0]);
  }

  await page.goto(link);
  await settled();
  return { browser, page, wrong, tab, number, settled, set, pictures };
}
