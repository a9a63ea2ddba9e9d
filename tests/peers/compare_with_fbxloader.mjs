// Compares the joints that mien reads from FBX files with those of three.js' FBXLoader.
//
//   node compare_with_fbxloader.mjs FOLDER_OF_THREE JOINTS.json FILE.fbx
//
// JOINTS.json is what the test FbxPeers writes: {"take", "metres_per_unit", "seconds": [...],
// "joints": {"name": [[x, y, z] for each time]}}, in metres with +Y up. Prints the largest distance
// over all joints and times in millimetres and ends with 1 if it is more than 0.1 mm.
//
// FBXLoader refuses version 6100, ignores the file's axes, interpolates keys linearly, and does not
// follow InheritType 2 (scales of the parent left out): files with these differ.

import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { join, resolve } from 'node:path';

const [folder, joints_file, fbx_file] = process.argv.slice(2);
// What the loader asks of a browser; it finds no pictures here.
globalThis.window = globalThis;
globalThis.self = globalThis;
globalThis.document = {
  createElementNS: () => ({ addEventListener() {}, removeEventListener() {}, style: {} }),
};
const load = (path) => import(pathToFileURL(join(resolve(folder), path)).href);
const THREE = await load('build/three.module.js');
const { FBXLoader } = await load('examples/jsm/loaders/FBXLoader.js');
console.warn = () => {};

const wanted = JSON.parse(readFileSync(joints_file, 'utf8'));
const bytes = readFileSync(fbx_file);
const root = new FBXLoader().parse(
  bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '');
const plain = (name) => THREE.PropertyBinding.sanitizeNodeName(name);
const mixer = new THREE.AnimationMixer(root);
const clip = root.animations.find((one) => one.name === wanted.take) ?? root.animations[0];
const action = clip ? mixer.clipAction(clip) : null;
if (action) {
  action.loop = THREE.LoopOnce;
  action.clampWhenFinished = true;
  action.play();
}

let farthest = 0;
let where = '';
let compared = 0;
const position = new THREE.Vector3();
for (const [index, seconds] of wanted.seconds.entries()) {
  if (action) mixer.setTime(seconds);
  root.updateMatrixWorld(true);
  for (const [name, positions] of Object.entries(wanted.joints)) {
    const node = root.getObjectByName(plain(name));
    if (!node) continue;
    position.setFromMatrixPosition(node.matrixWorld).multiplyScalar(wanted.metres_per_unit);
    const [x, y, z] = positions[index];
    const distance = Math.hypot(position.x - x, position.y - y, position.z - z);
    ++compared;
    if (distance > farthest) {
      farthest = distance;
      where = `${name} at ${seconds} s`;
    }
  }
}
console.log(`${fbx_file}: ${compared} positions, at most ${(1000 * farthest).toFixed(5)} mm apart ${where}`);
process.exit(compared > 0 && 1000 * farthest <= 0.1 ? 0 : 1);
