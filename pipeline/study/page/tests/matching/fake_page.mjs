// The page with a fake motion core, for looking at it and trying it: fakePage(FOLDER) writes it there.
import { fakeLivePage } from "../live/fake_page.mjs";

const trial = (number, target, kind, practice = false) =>
  ({ number, block: practice ? "practice" : kind, kind: "matching", media: [], target, interface: kind, practice });

const experiment = (more = {}) => ({
  format: "mien-matching-1", study: "try", title: "Make the same walk", language: "en", design: "d1",
  simulated: false, texts: { consent: ["Taking part is voluntary."], instructions: [], ending: ["Thank you."] },
  settings: { phones: "served" },
  matching: {
    limit_s: 300, threshold_m: 0.06, shows_distance: true, target_colour: "#2e8b57", created_colour: "#3465c8",
    sliders: {
      adjectives: { shown: ["quickness", "softness", "happiness", "strength"], offered: ["dryness", "maleness"] },
      features: { shown: ["stride", "arms"], offered: ["bow", "tempo"] },
      weights: { shown: ["normal", "long", "swinging", "bowed", "quick"], offered: [] },
    },
  },
  demographics: [],
  sessions: [{ participant: "p001", seed: "1", trials: [
    trial(1, "target-2", "adjectives", true), trial(2, "target-1", "adjectives"), trial(3, "target-1", "features"),
    trial(4, "target-1", "weights")] }],
  ...more,
});

export const fakePage = (folder, more) => fakeLivePage(folder, "matching", experiment(more));
