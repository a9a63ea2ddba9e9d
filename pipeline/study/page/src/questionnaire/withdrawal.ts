// A participant may withdraw at any time: what was stored is deleted.

import { button, element, heading, paragraphs } from "./elements";
import type { Destination } from "./experiment";
import type { Texts } from "./texts";

/**
 * Puts a button at the foot of the window, which asks once more before it withdraws. `withdraw` deletes what was
 * stored and returns where the participant is sent to; `after` shows what follows.
 */
export function offerWithdrawal(
  texts: Texts, withdraw: () => Promise<Destination | undefined>, after: (destination?: Destination) => void,
): void {
  if (document.querySelector(".withdrawal")) return;
  const wrong = element("p", { class: "wrong", role: "alert" });
  const dialog = element("dialog", { "aria-labelledby": "withdrawal-title" });
  const confirm = async () => {
    yes.disabled = true;
    try {
      const destination = await withdraw();
      dialog.close();
      endWithdrawalOffer();
      after(destination);
    } catch (error) {
      console.error(error);
      wrong.textContent = texts.withdrawFailed;
      yes.disabled = false;
    }
  };
  const yes = button(texts.withdraw, () => void confirm());
  const title = heading(texts.withdrawAsk);
  title.id = "withdrawal-title";
  dialog.append(title, ...paragraphs([texts.withdrawMeans]), wrong,
    element("div", { class: "buttons" }, button(texts.goOnWith, () => dialog.close(), "main"), yes));
  // Keys of the page behind, which choose answers, do nothing meanwhile.
  dialog.addEventListener("keydown", (event) => event.stopPropagation());
  const offer = button(texts.withdraw, () => dialog.showModal(), "quiet");
  document.body.append(element("footer", { class: "withdrawal" }, offer, dialog));
}

/** Takes the button away. */
export function endWithdrawalOffer(): void {
  document.querySelector(".withdrawal")?.remove();
}
