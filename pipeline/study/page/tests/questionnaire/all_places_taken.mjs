// The open link of a study of one participant, on a real mien study serve: somebody takes it to the end, somebody else
// is under way meanwhile; then both open the link again, and so does a third.
//   node all_places_taken.mjs LINK
// prints what they read as JSON. MIEN_PICTURES: a folder for screenshots.
import { join } from "node:path";
import { opener } from "./opened.mjs";
import { openBrowser, take } from "./participant.mjs";

const [link] = process.argv.slice(2);
const linkOf = (id) => `${link}?PROLIFIC_PID=${id}&STUDY_ID=s&SESSION_ID=${id}-s`;
const browser = await openBrowser();
const open = opener(browser);
const troubles = [];
const come = async (id) => {
  const opened = await open(linkOf(id));
  troubles.push(opened.troubles);
  return opened.page;
};
const read = async (page, id) => {
  await page.goto(linkOf(id));
  await page.waitForSelector(".page h1, .trial");
  if (process.env.MIEN_PICTURES) await page.screenshot({ path: join(process.env.MIEN_PICTURES, `${id}.png`) });
  return { said: await page.locator("main").innerText(), path: new URL(page.url()).pathname };
};

const [first, slow] = [await come("5f01"), await come("5f02")];
await slow.locator(".page .buttons .main").click();
await slow.waitForURL(/\/s\/[^/]*\/$/);
const under = new URL(slow.url()).pathname;
await take(first);
await first.waitForSelector(".leave");
const done = new URL(first.url()).pathname;
console.log(JSON.stringify({ done, under, first: await read(first, "5f01"), slow: await read(slow, "5f02"),
  third: await read(await come("5f03"), "5f03"), troubles: troubles.flat() }));
await browser.close();
