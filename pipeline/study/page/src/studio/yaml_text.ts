import { Document, isCollection, isPair, isScalar, visit, type Node, type Scalar, type ToStringOptions } from "yaml";
import { isMap, type Json } from "./document";

/** Lines are no longer than this, if that can be. */
const yamlWidth = 100;

/** Whether a text is itself in YAML, whatever it stands in and whatever reads it. */
const isItself = (text: string): boolean =>
  /^[A-Za-z][\w./-]*$/.test(text) && !/^(true|false|null|yes|no|on|off|y|n)$/i.test(text);

/** A value with "${" written so that it does not begin a variable. */
export function withoutVariables(value: Json): Json {
  if (typeof value === "string") return value.split("${").join("$${");
  if (Array.isArray(value)) return value.map(withoutVariables);
  if (!isMap(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, withoutVariables(one)]));
}

const style: ToStringOptions = { lineWidth: 0, flowCollectionPadding: false, doubleQuotedAsJSON: true };

/** With texts in quotes that might be read as something else. */
function documentOf(value: Json): Document {
  const document = new Document(value);
  visit(document, { Scalar: (_, node) => {
    if (typeof node.value === "string" && !isItself(node.value)) node.type = "QUOTE_DOUBLE";
  } });
  return document;
}

/** A value on one line: {a: 1, b: [x, "2"]}; a text in quotes of that type, if there is one. */
export function yamlLine(value: Json, quotes?: Scalar.Type): string {
  const document = documentOf(value);
  if (isScalar(document.contents) && quotes) document.contents.type = quotes;
  return document.toString({ ...style, collectionStyle: "flow" }).trimEnd();
}

/** A value whose first line begins `begin` bytes from its line's begin: on that line where it fits. Members
    and elements stand below each other otherwise, behind `column` spaces. */
export function yamlLines(value: Json, column: number, begin = column): string {
  const document = documentOf(value);
  visit(document, { Collection: (_, node, path) => {
    const above = path.filter((one) => isCollection(one)).length;
    const parent = path[path.length - 1];
    const name = isPair(parent) ? yamlLine((parent.key as Node).toJS(document)).length : 0;
    const from = above === 0 ? begin : column + 2 * above + name;
    node.flow = node.items.length === 0 || from + yamlLine(node.toJS(document)).length <= yamlWidth;
    return node.flow ? visit.SKIP : undefined;
  } });
  return document.toString(style).trimEnd().split("\n").join(`\n${" ".repeat(column)}`);
}

/** An element of a list, its dash behind `column` spaces: of a map, a member a line. */
export const yamlElement = (value: Json, column: number): string =>
  `- ${yamlLines(value, column + 2, isMap(value) ? Infinity : undefined)}`;
