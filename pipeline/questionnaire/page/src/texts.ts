/** What the pages themselves say; what the study says comes with the experiment. */
const english = {
  welcome: "Welcome",
  agree: "I agree and take part",
  refuse: "I do not take part",
  refused: "Thank you. You do not take part, and nothing was recorded. You may close this window.",
  instructions: "Instructions",
  keys: "You can use the keyboard for everything: Space plays a video, digits and arrow keys choose an answer, Tab moves on, Enter confirms.",
  turn_keys: "Turn the figure with the mouse, a finger or the arrow keys.",
  next: "Continue",
  about_you: "About you",
  optional: "may be left empty",
  number_wanted: "Please write a number.",
  answer_wanted: "Please answer this question.",
  preparing: "The videos are being loaded",
  preparing_of: (done: number, all: number) => `${done} of ${all} videos are loaded.`,
  load_failed: "A video could not be loaded. Please check the connection.",
  again: "Try again",
  practice: "Practice",
  practice_begins: "We begin with practice. These answers are not used.",
  main_begins: "The practice is over. Now the questions begin.",
  trial_of: (number: number, all: number) => `${number} of ${all}`,
  play: "Play",
  play_key: "Space",
  replay: "Play again",
  replays_left: (left: number) => (left === 1 ? "once more" : `${left} more times`),
  wait_for_video: "One moment …",
  watch_first: "You can answer when the video has ended.",
  play_first: "Play the video first.",
  stalled: "The video has stopped.",
  restart: "Start it again",
  rate: "How does this movement look to you?",
  which_emotion: "Which of these does the movement show?",
  which_of_two: "Which of the two movements looks more so?",
  more: (word: string) => `more ${word}`,
  left: "left",
  right: "right",
  to_rate: "Please judge this one",
  reference: "For comparison",
  describe: "Describe the movement in your own words.",
  comment: "Comment",
  missing: (count: number) => (count === 1 ? "One answer is missing." : `${count} answers are missing.`),
  attention: "This is a check without a video.",
  press_leftmost: "Please choose the leftmost answer.",
  press_rightmost: "Please choose the rightmost answer.",
  press_number: (place: number) => `Please choose answer number ${place} from the left.`,
  put_slider: (place: number) => `Please put the slider at ${place} of 100.`,
  saving: "Saving …",
  save_failed: "The connection is lost. Your answer is kept here and is being sent again; please leave this window open.",
  finish: "Finish",
  almost: "That was the last one",
  last_words: "Would you like to tell us anything about this questionnaire?",
  thanks: "Thank you",
  finished: "The questionnaire is finished and your answers are saved. You may close this window.",
  finished_files: "The questionnaire is finished. Your answers were saved as files in the download folder of this computer. If one is missing, save it again here.",
  save_file: (name: string) => `Save ${name}`,
  next_participant: "Start for the next participant",
  phone: "This questionnaire needs a larger screen than that of a phone. Please open it on a computer or a tablet.",
  trouble: "The questionnaire cannot be shown",
  resumed: "You go on where you stopped.",
  figure: "A moving figure, seen in three dimensions",
  video: "Video",
  very: "very", rather: "rather", slightly: "slightly", neither: "neither",
};

export type Texts = typeof english;

const japanese: Texts = {
  welcome: "ようこそ",
  agree: "同意して参加する",
  refuse: "参加しない",
  refused: "ありがとうございました。参加されないため、何も記録していません。この画面を閉じてください。",
  instructions: "説明",
  keys: "すべてキーボードで操作できます。スペースキーで動画を再生し、数字キーと矢印キーで回答を選び、Tabキーで移動し、Enterキーで確定します。",
  turn_keys: "マウス、指、または矢印キーで人物を回して見ることができます。",
  next: "次へ",
  about_you: "あなたについて",
  optional: "空欄でもかまいません",
  number_wanted: "数字を入力してください。",
  answer_wanted: "この質問に答えてください。",
  preparing: "動画を読み込んでいます",
  preparing_of: (done, all) => `${all}本中${done}本の動画を読み込みました。`,
  load_failed: "動画を読み込めませんでした。接続を確認してください。",
  again: "もう一度試す",
  practice: "練習",
  practice_begins: "まず練習をします。練習の回答は使われません。",
  main_begins: "練習は終わりです。ここから本番です。",
  trial_of: (number, all) => `${all}問中${number}問目`,
  play: "再生",
  play_key: "スペース",
  replay: "もう一度再生",
  replays_left: (left) => `あと${left}回`,
  wait_for_video: "お待ちください…",
  watch_first: "動画が終わると回答できます。",
  play_first: "先に動画を再生してください。",
  stalled: "動画が止まっています。",
  restart: "最初から再生する",
  rate: "この動きはどのように見えますか。",
  which_emotion: "この動きはどれを表していますか。",
  which_of_two: "二つの動きのうち、どちらがよりあてはまりますか。",
  more: (word) => `より${word}`,
  left: "左",
  right: "右",
  to_rate: "こちらを評価してください",
  reference: "比較用",
  describe: "この動きを自分の言葉で表してください。",
  comment: "コメント",
  missing: (count) => `未回答が${count}件あります。`,
  attention: "これは動画のない確認問題です。",
  press_leftmost: "一番左の答えを選んでください。",
  press_rightmost: "一番右の答えを選んでください。",
  press_number: (place) => `左から${place}番目の答えを選んでください。`,
  put_slider: (place) => `スライダーを100のうち${place}に合わせてください。`,
  saving: "保存しています…",
  save_failed: "接続が切れました。回答はここに保存され、再送しています。この画面を開いたままにしてください。",
  finish: "終了",
  almost: "これで最後です",
  last_words: "このアンケートについて何かあればお書きください。",
  thanks: "ありがとうございました",
  finished: "アンケートは終わりました。回答は保存されました。この画面を閉じてください。",
  finished_files: "アンケートは終わりました。回答はこのコンピューターのダウンロードフォルダーに保存されました。足りないものがあれば、ここでもう一度保存してください。",
  save_file: (name) => `${name}を保存`,
  next_participant: "次の参加者を始める",
  phone: "このアンケートには電話より大きな画面が必要です。パソコンかタブレットで開いてください。",
  trouble: "アンケートを表示できません",
  resumed: "続きから始めます。",
  figure: "立体的に見える動く人物",
  video: "動画",
  very: "とても", rather: "かなり", slightly: "少し", neither: "どちらでもない",
};

export const texts_of = (language: string): Texts => (language === "ja" ? japanese : english);

/** How much of its side a point of a scale means: "very"; the middle has a word of its own. */
export function degree_of(texts: Texts, place: number, points: number): string {
  const middle = (points + 1) / 2;
  const distance = Math.abs(place - middle);
  if (distance < 0.25) return texts.neither;
  const words = points <= 3 ? [""] : points <= 5 ? [texts.rather, texts.very]
    : [texts.slightly, texts.rather, texts.very];
  const share = distance / ((points - 1) / 2);
  return words[Math.max(0, Math.ceil(share * words.length - 1e-9) - 1)]!;
}

/** What a point means in full: "very sad". */
export function meaning_of(
  texts: Texts, language: string, place: number, points: number, left: string, right: string,
): string {
  const middle = (points + 1) / 2;
  const degree = degree_of(texts, place, points);
  if (place === middle) return degree;
  return [degree, place < middle ? left : right].filter(Boolean).join(language === "ja" ? "" : " ");
}
