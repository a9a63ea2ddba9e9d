import { isCollection, isMap, isScalar, isSeq, type Node } from "yaml";
import { changed, changesBetween, pathText, sayTheSame, type DocumentChange } from "./document_change";
import type { Json } from "./document";
import { withoutVariables, yamlElement, yamlLine, yamlLines } from "./yaml_text";
import { YamlSource, type Child } from "./yaml_source";

/** What is to stand in the place of a part of a text. */
interface TextChange {
  begin: number;
  end: number;
  text: string;
}

const inserted = (at: number, text: string): TextChange => ({ begin: at, end: at, text });

/** A change in one collection of a text. */
class CollectionChange {
  private readonly children: Child[];
  private readonly isFlow: boolean;
  /** Before the keys or dashes of block style. */
  private readonly column: number;

  constructor(private readonly source: YamlSource, private readonly parent: Node, private readonly change: DocumentChange) {
    this.children = source.childrenOf(parent);
    this.isFlow = isCollection(parent) && parent.flow === true;
    const head = this.children[0]?.head ?? 0;
    this.column = head - source.beginOfLine(head);
  }

  text(): TextChange {
    const { kind, path } = this.change;
    const step = path[path.length - 1]!;
    const index = this.children.findIndex((child) => child.step === step);
    if (kind === "insert" && typeof step === "number" && step <= this.children.length) return this.insert(step, this.change.value);
    if (kind === "set" && index >= 0) return this.replace(this.children[index]!, this.change.value);
    if (kind === "set" && typeof step === "string") return this.add(step, this.change.value);
    if (kind === "remove" && index >= 0) return this.remove(index);
    return this.source.refuseMissing(this.parent, step);
  }

  private margin = (): string => `\n${" ".repeat(this.column)}`;

  private replace({ begin: head, value: old, end }: Child, value: Json): TextChange {
    if (!old) return inserted(end, `: ${yamlLine(value)}`);
    this.source.refuseShared(old);
    const [begin] = old.range!;
    const { text } = this.source;
    if (begin === end)
      return inserted(end, `${/\s/.test(text[end - 1]!) ? "" : " "}${yamlLine(value)}${text[end] === "#" ? " " : ""}`);
    const isQuoted = isScalar(old) && typeof value === "string" && old.type?.startsWith("QUOTE");
    const quotes = isQuoted && !/[\n\r\t]/.test(value) ? old.type : undefined;
    if (quotes || this.isFlow || !isMap(this.parent)) return { begin, end, text: yamlLine(value, quotes) };
    const line = this.source.beginOfLine(begin);
    const lines = yamlLines(value, this.column + 2, begin - line);
    if (!lines.includes("\n") || line !== this.source.beginOfLine(head)) return { begin, end, text: lines };
    return { begin: text.slice(0, begin).trimEnd().length, end, text: `${this.margin()}  ${lines}` };
  }

  private add(name: string, value: Json): TextChange {
    if (!isMap(this.parent)) throw this.source.refusal(this.parent.range![0],
      `there is no map here for "${name}"`, 'write "{}" here, or the value by hand');
    const member = { [name]: value };
    if (this.isFlow) return this.insertInBrackets(this.children.length, yamlLine(member).slice(1, -1));
    return inserted(this.source.endOfLine(this.children[this.children.length - 1]!.end),
      `${this.margin()}${yamlLines(member, this.column, Infinity)}`);
  }

  private insert(index: number, value: Json): TextChange {
    if (!isSeq(this.parent)) throw this.source.refusal(this.parent.range![0],
      "there is no list here", 'write "[]" here, or the value by hand');
    if (this.isFlow) return this.insertInBrackets(index, yamlLine(value));
    const element = yamlElement(value, this.column);
    if (index === 0) return inserted(this.children[0]!.head, `${element}${this.margin()}`);
    return inserted(this.source.endOfLine(this.children[index - 1]!.end), `${this.margin()}${element}`);
  }

  private insertInBrackets(index: number, text: string): TextChange {
    if (this.children.length === 0) return inserted(this.parent.range![0] + 1, text);
    return index === 0 ? inserted(this.children[0]!.begin, `${text}, `) : inserted(this.children[index - 1]!.end, `, ${text}`);
  }

  private remove(index: number): TextChange {
    const { source, children } = this;
    const [before, child, next] = [children[index - 1], children[index]!, children[index + 1]];
    if (child.value) source.refuseShared(child.value);
    if (!before && !next) return this.isFlow ? { begin: child.begin, end: child.end, text: "" }
      : { begin: this.parent.range![0], end: child.end, text: isMap(this.parent) ? "{}" : "[]" };
    if (this.isFlow) return next ? this.without(child.begin, next.begin, child.end) : this.without(before!.end, child.end, before!.end, child.begin);
    const line = source.beginOfLine(child.head);
    const isBehindDash = source.text.slice(line, child.head).trim() !== "";
    if (isBehindDash) return this.without(child.head, next!.head, source.endOfLine(child.end));
    const end = source.text.indexOf("\n", child.end);
    if (end >= 0) return { begin: line, end: end + 1, text: "" };
    return { begin: line - /(\r?\n)?$/.exec(source.text.slice(0, line))![0].length, end: source.text.length, text: "" };
  }

  /** What goes; throws Refusal where a comment between two members would go with it. */
  private without(begin: number, end: number, from: number, to = end): TextChange {
    if (this.source.text.slice(from, to).includes("#")) throw this.source.refusal(begin,
      "a comment beside this value would be lost", "move the comment, or remove the value from the file by hand");
    return { begin, end, text: "" };
  }
}

/** The text after a change, or null where it says something else then. */
function afterChange(source: YamlSource, file: string, change: DocumentChange): string | null {
  const { text } = source;
  const parent = source.parentOf(change.path);
  const { begin, end, text: made } = new CollectionChange(source, parent, change).text();
  const lineBreak = /\r\n/.test(text) ? "\r\n" : "\n";
  const next = text.slice(0, begin) + made.split("\n").join(lineBreak) + text.slice(end);
  try {
    return sayTheSame(new YamlSource(next, file).value(), changed(source.value(), change)) ? next : null;
  } catch {
    return null;
  }
}

/** The text with what makes its document `to` out of `from`: lines that this does not touch stay as they are
    to the last byte, comments, order, anchors, quotes and indentation included. `file` is what the text is
    called.

    Throws Refusal, with the place, for what cannot be changed so: values behind an alias or a merge key,
    values that an alias uses elsewhere, comments that would be lost between two members, and forms of YAML
    that are not known here. */
export function edited(text: string, file: string, from: Json, to: Json): string {
  let now = text;
  for (const found of changesBetween(from, to)) {
    const change = found.kind === "remove" ? found : { ...found, value: withoutVariables(found.value) };
    const source = new YamlSource(now, file);
    const next = afterChange(source, file, change);
    if (next === null) throw source.refusal(source.parentOf(change.path).range![0],
      `${pathText(change.path)} cannot be changed in this form of YAML`,
      "edit the file by hand, or write the value there in plain form");
    now = next;
  }
  return now;
}
