import { Color, Group, Quaternion } from "three";
import { sideOf, type Body } from "./body_shape";
import { weightsAt, type FaceFrames } from "./face";
import { Figure } from "./figure";
import { Skin } from "./skin";
import type { Turned } from "./turned";

// What the program tells of the people of a film (pipeline/study/figures/shown_people.h).

interface PersonHead {
  body: Body;
  hands: Body | null;
  /** Of the middle, the left and the right: linear red, green and blue. */
  colours: [number, number, number][];
  /** The place of its file among the figures; -1: a stick figure. */
  file: number;
  /** Of the poses; 0: those of the body. */
  joints: number;
  morphs: number;
  face_frames: number;
}

export interface PeopleHead {
  fps: number;
  frames: number;
  /** From where several people are seen first: x, z. */
  front: [number, number] | null;
  people: PersonHead[];
  /** Names of the files of figures. */
  figures: string[];
}

const jointsOf = ({ joints, body }: PersonHead): number => joints || body.names.length;

/** How many numbers tell of a person's poses and face. */
const countOf = (person: PersonHead, frames: number): number =>
  7 * frames * jointsOf(person) + person.morphs * person.face_frames;

/** How many numbers tell of all people. */
export const countOfPeople = ({ people, frames }: PeopleHead): number =>
  people.reduce((sum, person) => sum + countOf(person, frames), 0);

/** One of the people; its numbers begin at `begin`. */
class TurnedPerson {
  readonly figure: Figure;
  readonly count: number;
  readonly positions: Float32Array;
  private rotations: Float32Array;
  private face: FaceFrames | null = null;
  private nowAt: Float32Array;
  private nowTurned: Float32Array;
  private root = 0;
  private skinHeight = 0;

  constructor(private head: PersonHead, private frames: number, numbers: Float32Array, begin: number) {
    this.count = jointsOf(head);
    const places = frames * this.count;
    const faceAt = begin + 7 * places;
    const end = begin + countOf(head, frames);
    this.positions = numbers.subarray(begin, begin + 3 * places);
    this.rotations = numbers.subarray(begin + 3 * places, faceAt);
    if (head.morphs > 0) this.face = { weights: numbers.subarray(faceAt, end), frames: head.face_frames };
    this.nowAt = new Float32Array(3 * this.count);
    this.nowTurned = new Float32Array(4 * this.count);
    this.figure = new Figure(head.body, "#808080", head.hands);
    this.figure.paint(head.body.names.map((name) => this.colourOf(name)));
  }

  private colourOf(joint: string): Color {
    const side = { left: 1, right: 2 }[sideOf(joint)] ?? 0;
    return new Color(...this.head.colours[side]!);
  }

  /** In the surface of its file. */
  wear(skin: Skin): void {
    this.figure.paint(null);
    this.figure.wear(skin);
    this.skinHeight = skin.height;
    this.root = Math.max(0, skin.joints.findIndex((joint) => joint.userData["body_joint"] === 0));
  }

  /** Of what is seen at its highest, metres: a surface may reach beyond its joints. */
  height(): number {
    let highest = this.skinHeight;
    for (let i = 1; i < this.positions.length; i += 3) highest = Math.max(highest, this.positions[i]! + aboveJoints);
    return highest;
  }

  pose(at: number, fps: number): void {
    const frame = Math.floor(at);
    const next = Math.min(frame + 1, this.frames - 1);
    const share = at - frame;
    const { positions, rotations, count } = this;
    for (let i = 0; i < 3 * count; i += 1) {
      const here = positions[3 * frame * count + i]!;
      this.nowAt[i] = here + share * (positions[3 * next * count + i]! - here);
    }
    for (let j = 0; j < 4 * count; j += 4)
      Quaternion.slerpFlat(this.nowTurned as unknown as number[], j, rotations as unknown as number[],
        4 * frame * count + j, rotations as unknown as number[], 4 * next * count + j, share);
    this.figure.standAs(this.nowAt, this.nowTurned, this.face ? weightsAt(this.face, at / fps, fps) : null);
  }

  place(): { x: number; z: number } {
    return { x: this.nowAt[3 * this.root]!, z: this.nowAt[3 * this.root + 2]! };
  }
}

/** How far heads and hands reach above the joints, metres. */
const aboveJoints = 0.12;

interface Circle {
  x: number;
  z: number;
  radius: number;
}

/** On the floor, around all that people do. */
function circleAround(people: TurnedPerson[]): Circle {
  const least = [Infinity, Infinity];
  const most = [-Infinity, -Infinity];
  for (const { positions } of people) {
    for (let i = 0; i < positions.length; i += 3) {
      [positions[i]!, positions[i + 2]!].forEach((place, axis) => {
        least[axis] = Math.min(least[axis]!, place);
        most[axis] = Math.max(most[axis]!, place);
      });
    }
  }
  return { x: (least[0]! + most[0]!) / 2, z: (least[1]! + most[1]!) / 2,
    radius: Math.hypot(most[0]! - least[0]!, most[1]! - least[1]!) / 2 };
}

/** So far away that all of the circle is in view, metres. */
const distanceOf = (circle: Circle): number => Math.min(12, Math.max(3.7, 3.2 * circle.radius + 1));

/** So far away that nothing up to this height is cut off, before a camera that looks at a height of 0.9 m, metres. */
const distanceOfHeight = (height: number): number => Math.min(12, Math.max(3.7, (height - 0.8) / 0.27));

/** People as in the film, each in a figure of its own. `figures`: the bytes of their files. */
export async function peopleOf(head: PeopleHead, numbers: Float32Array, figures: ArrayBuffer[]): Promise<Turned> {
  let begin = 0;
  const people = head.people.map((person) => {
    const made = new TurnedPerson(person, head.frames, numbers, begin);
    begin += countOf(person, head.frames);
    return made;
  });
  await Promise.all(head.people.map(async ({ file }, i) => {
    if (file >= 0) people[i]!.wear(await Skin.read(figures[file]!));
  }));
  const object = new Group();
  object.add(...people.map(({ figure }) => figure.group));
  const circle = circleAround(people);
  const tallest = distanceOfHeight(Math.max(...people.map((person) => person.height())));
  return {
    object,
    seconds: head.frames / head.fps,
    stands: head.front
      ? { azimuth: Math.atan2(head.front[0], head.front[1]), distance: Math.max(distanceOf(circle), tallest) }
      : { distance: tallest },
    pose: (seconds) => people.forEach((person) =>
      person.pose(Math.min(seconds * head.fps, head.frames - 1), head.fps)),
    middle: () => (people.length > 1 ? circle : people[0]!.place()),
    release: () => people.forEach(({ figure }) => figure.release()),
  };
}

/** Of a file: a head and its numbers. */
export function readPeople(bytes: ArrayBuffer, figures: ArrayBuffer[]): Promise<Turned> {
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as PeopleHead;
  return peopleOf(head, new Float32Array(bytes, 4 + length), figures);
}
