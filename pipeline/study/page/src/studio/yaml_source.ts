import { isAlias, isCollection, isMap, isScalar, LineCounter, parseDocument, visit, type CST, type Document, type Node,
  type Pair, type YAMLMap, type YAMLSeq } from "yaml";
import type { Json } from "./document";
import type { Step } from "./document_change";
import { Refusal } from "./refusal";

type Collection = YAMLMap<Node, Node | null> | YAMLSeq<Node>;

/** A member or an element as it stands in a text; places are offsets in it. */
export interface Child {
  step: Step;
  value: Node | null;
  /** The dash of an element in block style, the key's or the value's anchor, tag or first byte otherwise. */
  head: number;
  begin: number;
  /** Behind the last byte, comments apart. */
  end: number;
}

/** A manifest's text, and the tree of its values. */
export class YamlSource {
  private readonly lines = new LineCounter();
  private readonly document: Document.Parsed;

  /** `file`: what the text is called. Throws Refusal for what is no YAML. */
  constructor(readonly text: string, private readonly file: string) {
    this.document = parseDocument(text, { keepSourceTokens: true, merge: true, lineCounter: this.lines });
    const [error] = this.document.errors;
    if (error) throw this.refusal(error.pos[0], error.message.split(" at line ")[0]!, "correct it in the file by hand");
  }

  value = (): Json => this.document.toJS() as Json;

  refusal(at: number, wrong: string, remedy: string): Refusal {
    const { line, col } = this.lines.linePos(at);
    return new Refusal([{ path: `${this.file}:${line}:${col}`, wrong, remedy }]);
  }

  beginOfLine(at: number): number {
    const begin = at === 0 ? 0 : this.text.lastIndexOf("\n", at - 1) + 1;
    return begin === 0 && this.text.startsWith("\uFEFF") ? 1 : begin;
  }

  /** Before the line break. */
  endOfLine(at: number): number {
    const found = this.text.indexOf("\n", at);
    const end = found < 0 ? this.text.length : found;
    return end > at && this.text[end - 1] === "\r" ? end - 1 : end;
  }

  /** The collection that a path's last step leads into. Throws Refusal where something stands in the way. */
  parentOf(path: Step[]): Node {
    let parent = this.document.contents as Node;
    this.refuseShared(parent);
    for (const step of path.slice(0, -1)) {
      parent = this.childrenOf(parent).find((child) => child.step === step)?.value ?? this.refuseMissing(parent, step);
      this.refuseShared(parent);
    }
    return parent;
  }

  /** Of what is no collection: none. */
  childrenOf(parent: Node): Child[] {
    if (!isCollection(parent)) return [];
    const { items, srcToken } = parent as Collection & { srcToken?: { items: CST.CollectionItem[] } };
    return items.map((item, i) => {
      const [first, value] = isMap(parent) ? [(item as Pair<Node>).key, (item as Pair<Node, Node>).value] : [item as Node, item as Node];
      const { start } = srcToken!.items[i]!;
      const begin = start.find(({ type }) => type === "anchor" || type === "tag")?.offset ?? first.range![0];
      const head = start.find(({ type }) => type === "seq-item-ind")?.offset ?? begin;
      const step = !isMap(parent) ? i : isScalar(first) ? first.source ?? String(first.value) : "";
      return { step, value, head, begin, end: Math.max(this.endOf(first), value ? this.endOf(value) : 0) };
    });
  }

  private endOf(node: Node): number {
    const [begin, end] = node.range!;
    if (isCollection(node) && !node.flow) return this.childrenOf(node).at(-1)!.end;
    return begin + this.text.slice(begin, end).trimEnd().length;
  }

  /** Throws Refusal for what stands elsewhere, behind an alias, and for what an alias uses again. */
  refuseShared(node: Node): void {
    const at = node.range![0];
    if (isAlias(node)) throw this.refusal(at, "this value is defined elsewhere in the file, through an alias",
      "write the value out here, or edit it by hand at its anchor");
    let line = 0;
    if (node.anchor) visit(this.document, { Alias: (_, { source, range }) => {
      if (source === node.anchor) line ||= this.lines.linePos(range![0]).line;
    } });
    if (line > 0) throw this.refusal(at, `this value is used again by the alias on line ${line}`,
      "write the value out there, or change it by hand");
  }

  refuseMissing(parent: Node, step: Step): never {
    const at = parent.range![0];
    if (this.childrenOf(parent).some((child) => child.step === "<<"))
      throw this.refusal(at, `"${step}" comes from the merge key << of this map`,
        "write the value out here, or edit it by hand at its anchor");
    throw this.refusal(at, `there is no "${step}" here`, "load the file again");
  }
}
