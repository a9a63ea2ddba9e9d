// What stands for JATOS in tests.

/** In the place of JATOS's own script: what it keeps outlives a reload. */
export const jatosScript = `
const kept = JSON.parse(sessionStorage.jatos ?? "{}");
const keep = () => { sessionStorage.jatos = JSON.stringify(kept); };
globalThis.jatos = {
  urlQueryParameters: Object.fromEntries(new URLSearchParams(location.search)),
  workerId: 7,
  batchId: 3,
  studyResultId: 12,
  studySessionData: kept.session ?? {},
  onLoad: (ready) => setTimeout(ready, 20),
  batchSession: {
    get: (name) => (kept.batch ?? { mien_taken: { p001: 1, p003: 1 } })[name],
    set: async (name, value) => {
      if (!kept.refused) { kept.refused = true; keep(); throw new Error("an old state"); }
      kept.batch = { [name]: value }; keep();
    },
  },
  setStudySessionData: async (value) => { kept.session = value; keep(); },
  submitResultData: async (text) => { kept.result = text; keep(); },
  uploadResultFile: async (text, name) => { (kept.files ??= {})[name] = text; keep(); },
  endStudy: async () => { kept.ended = true; keep(); },
  abortStudyWithoutRedirect: async () => { kept.aborted = true; delete kept.result; keep(); },
};
`;
