// How far apart both motions are: over time, and by part of the body.

const chartRow = 15, chartTop = 26, chartHeight = 96, chartLeft = 112, chartRight = 10;

/// A round length of time that fits about so many times.
function tickStep(seconds, ticks) {
  const rough = Math.max(seconds, 1e-6) / ticks, ten = 10 ** Math.floor(Math.log10(rough));
  return ten * [1, 2, 5, 10].find(step => step * ten >= rough);
}

function partAt(motion, moment) {
  return motion.parts.reduce((most, part) => (part.curve[moment] ?? 0) > (most.curve[moment] ?? 0) ? part : most, motion.parts[0]);
}

function millimetres(value) {
  return `${value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2)} mm`;
}

/// From nothing to the most, against the page's ground.
const shade = share => heat(isDark() ? share : 1 - share);

function distanceChart(motion, clock) {
  if (!(Math.max(...motion.curve) > 0)) {
    const seconds = (motion.curve.length / motion.fps).toFixed(2);
    return {node: element("p", {class: "wide quiet"}, `No joint is elsewhere in the ${seconds} s that both motions have.`), paint: () => {}};
  }
  const moments = motion.curve.length;
  const most = Math.max(1e-9, ...motion.curve);
  const rowsTop = chartTop + chartHeight + 30;
  const height = rowsTop + chartRow * motion.parts.length + 30;
  const worstPart = partAt(motion, motion.worst);
  const worstText = `${millimetres(most)}, ${worstPart.name} at ${(motion.worst / motion.fps).toFixed(2)} s`;
  const canvas = element("canvas", {class: "chart", role: "img",
    "aria-label": `Distance of both motions over time and by part of the body. The most: ${worstText}.`});
  const told = element("span");
  const caption = element("figcaption", {}, "Distance of a joint, or of a point 10 cm beside it, before and now. Click to go to a frame. ", told);
  let width = 640;
  const x = moment => chartLeft + (width - chartLeft - chartRight) * (moments > 1 ? moment / (moments - 1) : 0.5);
  const y = value => chartTop + chartHeight * (1 - value / most);

  function drawCurve(context) {
    context.strokeStyle = colour("--line");
    context.fillStyle = colour("--quiet");
    context.textAlign = "right";
    for (const share of [0, 0.5, 1]) {
      const up = Math.round(y(share * most)) + 0.5;
      context.beginPath(); context.moveTo(chartLeft, up); context.lineTo(width - chartRight, up); context.stroke();
      context.fillText(share ? millimetres(share * most) : "0 mm", chartLeft - 8, up + 4);
    }
    context.textAlign = "center";
    const seconds = (moments - 1) / motion.fps, step = tickStep(seconds, 8), digits = step < 0.1 ? 2 : step < 1 ? 1 : 0;
    for (let second = 0; second <= seconds + 1e-9; second += step)
      context.fillText(`${second.toFixed(digits)} s`, x(second * motion.fps), chartTop + chartHeight + 18);
    context.strokeStyle = colour("--ink");
    context.lineWidth = 1.75;
    context.beginPath();
    motion.curve.forEach((value, moment) => context.lineTo(x(moment), y(value)));
    context.stroke();
    context.lineWidth = 1;
  }
  function drawWorst(context) {
    context.fillStyle = colour("--bad");
    context.beginPath(); context.arc(x(motion.worst), y(most), 4.5, 0, 7); context.fill();
    const text = `worst: ${worstText}`, half = context.measureText(text).width / 2;
    context.textAlign = "center";
    context.fillText(text, Math.min(width - chartRight - half, Math.max(chartLeft + half, x(motion.worst))), chartTop - 10);
  }
  function drawParts(context) {
    const cell = (width - chartLeft - chartRight) / Math.max(1, moments - 1);
    motion.parts.forEach((part, row) => {
      const up = rowsTop + chartRow * row;
      context.fillStyle = colour(part === worstPart ? "--bad" : "--quiet");
      context.textAlign = "right";
      context.fillText(part.name, chartLeft - 8, up + chartRow - 4);
      part.curve.forEach((value, moment) => {
        context.fillStyle = shade(value / most);
        const from = Math.max(chartLeft, Math.floor(x(moment) - cell / 2)), to = Math.min(width - chartRight, Math.ceil(x(moment) + cell / 2));
        context.fillRect(from, up, Math.max(1, to - from), chartRow - 1);
      });
    });
  }
  function drawLegend(context) {
    const up = rowsTop + chartRow * motion.parts.length + 9;
    for (let i = 0; i < 120; ++i) { context.fillStyle = shade(i / 119); context.fillRect(chartLeft + i, up, 1, 9); }
    context.fillStyle = colour("--quiet");
    context.textAlign = "right"; context.fillText("0 mm", chartLeft - 8, up + 9);
    context.textAlign = "left"; context.fillText(millimetres(most), chartLeft + 128, up + 9);
  }
  let picture = null;
  function paint() {
    width = Math.max(320, Math.round(canvas.clientWidth || 640));
    canvas.style.height = `${height}px`;
    const context = prepared(canvas, width, height);
    context.font = '12px "Noto Sans", system-ui, sans-serif';
    drawParts(context); drawCurve(context); drawWorst(context); drawLegend(context);
    picture = document.createElement("canvas");
    picture.width = canvas.width; picture.height = canvas.height;
    picture.getContext("2d").drawImage(canvas, 0, 0);
    mark();
  }
  function mark() {
    if (!picture) return;
    const moment = Math.min(moments - 1, Math.round(clock.seconds() * motion.fps));
    const context = canvas.getContext("2d");
    context.save(); context.resetTransform(); context.clearRect(0, 0, canvas.width, canvas.height); context.drawImage(picture, 0, 0); context.restore();
    const bottom = rowsTop + chartRow * motion.parts.length;
    context.strokeStyle = colour("--paper"); context.lineWidth = 4;
    context.beginPath(); context.moveTo(x(moment), chartTop); context.lineTo(x(moment), bottom); context.stroke();
    context.strokeStyle = colour("--mark"); context.lineWidth = 2; context.stroke(); context.lineWidth = 1;
    const part = partAt(motion, moment);
    told.textContent = `At ${(moment / motion.fps).toFixed(2)} s: ${part.name} ${millimetres(part.curve[moment] ?? 0)}.`;
  }
  const follow = event => {
    const box = canvas.getBoundingClientRect();
    const share = (event.clientX - box.left - chartLeft) / (box.width - chartLeft - chartRight);
    clock.stop();
    clock.go(clock.frameAt(Math.min(1, Math.max(0, share)) * (moments - 1) / motion.fps));
  };
  canvas.addEventListener("pointerdown", follow);
  canvas.addEventListener("pointermove", event => { if (event.buttons & 1) follow(event); });
  clock.tell(mark);
  return {node: element("figure", {class: "wide"}, canvas, caption), paint};
}
