// Both motions as figures of lines on a floor, from a side that can be turned.

/// World places of joints in millimetres: frame f, joint j, axis a.
function posesOf(packed) {
  const bytes = atob(packed.places.slice(packed.places.indexOf(",") + 1));
  const values = new Int16Array(bytes.length / 2);
  for (let i = 0; i < values.length; ++i) values[i] = bytes.charCodeAt(2 * i) | bytes.charCodeAt(2 * i + 1) << 8;
  const count = values.length / (3 * packed.joints);
  return {
    count, joints: packed.joints, bones: packed.bones, fps: packed.fps,
    frameAt: seconds => Math.min(count - 1, Math.max(0, Math.round(seconds * packed.fps))),
    place: (frame, joint) => [0, 1, 2].map(axis => packed.step_mm * values[3 * (frame * packed.joints + joint) + axis])};
}

/// The side from which most of the difference at a moment is seen, and something of the figure.
function bestTurn(before, now, seconds) {
  const [b, n] = [before.frameAt(seconds), now.frameAt(seconds)];
  const apart = [], spread = [], root = now.place(n, 0);
  for (let j = 0; j < Math.min(before.joints, now.joints); ++j) {
    const [p, q] = [before.place(b, j), now.place(n, j)];
    apart.push([q[0] - p[0], q[2] - p[2]]);
    spread.push([q[0] - root[0], q[2] - root[2]]);
  }
  const seen = (vectors, turn) => vectors.reduce((sum, [x, z]) => sum + (Math.cos(turn) * x - Math.sin(turn) * z) ** 2, 0);
  const whole = vectors => vectors.reduce((sum, [x, z]) => sum + x * x + z * z, 1e-9);
  let best = 0.6, most = -1;
  for (let i = 0; i < 24; ++i) {
    const turn = Math.PI * i / 12;
    const share = seen(apart, turn) / whole(apart) + 0.8 * seen(spread, turn) / whole(spread) + 0.01 * Math.cos(turn);
    if (share > most) { most = share; best = turn; }
  }
  return best;
}

function motionView(motion, clock) {
  const before = posesOf(motion.before), now = posesOf(motion.now);
  const canvas = element("canvas", {class: "space", tabindex: "0", role: "img",
    "aria-label": "Both motions in 3-D, before in orange and now in blue. A and D turn it, W and S tilt it."});
  const told = element("span");
  const caption = element("figcaption", {}, element("span", {class: "before"}, "━ before"), "  ", element("span", {class: "now"}, "━ now"),
    "  ", told, " A square is 0.5 m. Drag, or ", element("kbd", {}, "A"), " ", element("kbd", {}, "D"), " ", element("kbd", {}, "W"), " ",
    element("kbd", {}, "S"), ", to turn.");
  let turn = bestTurn(before, now, clock.seconds()) + 0.3, tilt = 0.22;  // a little aside, to see depth
  let low = Infinity, high = -Infinity;
  for (const poses of [before, now]) {
    for (let f = 0; f < poses.count; ++f) {
      for (let j = 0; j < poses.joints; ++j) { const up = poses.place(f, j)[1]; low = Math.min(low, up); high = Math.max(high, up); }
    }
  }
  const floor = Math.min(0, low), tall = Math.max(high - floor, 500);

  const hasEnded = poses => clock.seconds() * poses.fps > poses.count - 0.5;

  function draw() {
    const width = Math.max(240, canvas.clientWidth || 480), height = Math.max(240, canvas.clientHeight || 360);
    const context = prepared(canvas, width, height);
    const seconds = clock.seconds(), b = before.frameAt(seconds), n = now.frameAt(seconds);
    const [rootB, rootN] = [before.place(b, 0), now.place(n, 0)];
    const centre = [(rootB[0] + rootN[0]) / 2, floor + tall / 2, (rootB[2] + rootN[2]) / 2];
    const scale = height / (tall * 1.3), [sin, cos, lift, flat] = [Math.sin(turn), Math.cos(turn), Math.sin(tilt), Math.cos(tilt)];
    const seen = place => {
      const [x, y, z] = place.map((value, axis) => value - centre[axis]);
      return [width / 2 + scale * (cos * x - sin * z), height / 2 - scale * (flat * y - lift * (sin * x + cos * z))];
    };
    const line = (from, to) => { context.beginPath(); context.moveTo(...seen(from)); context.lineTo(...seen(to)); context.stroke(); };
    drawFloor(context, centre, line);
    for (const [poses, frame, name, wide] of [[before, b, "--before", 6], [now, n, "--now", 3]]) {
      context.strokeStyle = context.fillStyle = colour(name);
      context.lineWidth = wide;
      context.lineCap = "round";
      for (const [from, to] of poses.bones) line(poses.place(frame, from), poses.place(frame, to));
    }
    tellFarthest(context, seen, b, n, width);
    told.textContent = `Frame ${clock.frame}, ${seconds.toFixed(2)} s.${hasEnded(before) ? " Before has ended." : ""}${hasEnded(now) ? " Now has ended." : ""}`;
  }
  function drawFloor(context, centre, line) {
    const square = 500, reach = 3;
    context.strokeStyle = colour("--line");
    context.lineWidth = 1;
    const [x0, z0] = [Math.round(centre[0] / square) * square, Math.round(centre[2] / square) * square];
    for (let i = -reach; i <= reach; ++i) {
      line([x0 + i * square, floor, z0 - reach * square], [x0 + i * square, floor, z0 + reach * square]);
      line([x0 - reach * square, floor, z0 + i * square], [x0 + reach * square, floor, z0 + i * square]);
    }
  }
  /// Names the part that is farthest apart, beside it.
  function tellFarthest(context, seen, b, n, width) {
    const moment = Math.min(motion.curve.length - 1, Math.round(clock.seconds() * motion.fps));
    const part = partAt(motion, moment);
    if (!(part?.curve[moment] > 0) || before.joints !== now.joints || hasEnded(before) || hasEnded(now)) return;
    let most = 0, at = null;
    for (let j = 0; j < now.joints; ++j) {
      const [p, q] = [before.place(b, j), now.place(n, j)];
      const apart = Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      if (apart > most) { most = apart; at = [p, q]; }
    }
    if (!at) return;
    const [x, y] = seen(at[1]);
    context.strokeStyle = colour("--bad");
    context.lineWidth = 1.5;
    context.beginPath(); context.arc(x, y, 9, 0, 7); context.stroke();
    context.font = '13px "Noto Sans", system-ui, sans-serif';
    const text = `${part.name} ${millimetres(part.curve[moment])}`;
    const room = context.measureText(text).width + 20, left = x + room > width || x < width / 2 && x > room;  // away from the figure
    context.textAlign = left ? "right" : "left";
    context.strokeStyle = colour("--paper"); context.lineWidth = 4; context.lineJoin = "round";
    context.strokeText(text, x + (left ? -16 : 16), y + 4);
    context.fillStyle = colour("--bad");
    context.fillText(text, x + (left ? -16 : 16), y + 4);
  }
  const turned = (aside, up) => { turn += aside; tilt = Math.min(1.5, Math.max(0, tilt + up)); draw(); };
  canvas.addEventListener("pointermove", event => { if (event.buttons & 1) turned(event.movementX * 0.01, event.movementY * 0.01); });
  clock.tell(draw);
  const turns = {a: [0.15, 0], d: [-0.15, 0], w: [0, 0.1], s: [0, -0.1]};
  return {node: element("figure", {}, canvas, caption), paint: draw, keys: event => {
    const by = turns[event.key.toLowerCase()];
    if (by) turned(...by);
    return Boolean(by);
  }};
}
