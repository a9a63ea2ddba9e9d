// The module itself, in a worker or on the page. This function is also sent to workers as text, so it
// uses nothing from outside itself.

/** What is asked of a module: a bundle to open first, then motions. */
export type WasmRequest =
  | { what: "open"; module: ArrayBuffer; bundle: ArrayBuffer }
  | { what: "example" | "target"; name: string }
  | { what: "make"; setting: { kind: string; sliders: string[]; values: number[] } }
  | { what: "distance"; target: string; setting: { kind: string; sliders: string[]; values: number[] } };

export type WasmAnswer = (request: WasmRequest) => Promise<ArrayBuffer>;

export function wasmInstance(): WasmAnswer {
  interface Exports {
    memory: WebAssembly.Memory;
    _initialize(): void;
    live_room(size: number): number;
    live_leave(place: number): void;
    live_open(place: number, size: number): number;
    live_set(kind: number): void;
    live_slider(name: number, size: number, value: number): void;
    live_make(): number;
    live_distance(name: number, size: number): number;
    live_example(name: number, size: number): number;
    live_target(name: number, size: number): number;
    live_result(): number;
    live_result_size(): number;
  }
  let core: Exports | undefined;
  const text = new TextEncoder();

  const result = (exports: Exports): ArrayBuffer => {
    const place = exports.live_result();
    return exports.memory.buffer.slice(place, place + exports.live_result_size()) as ArrayBuffer;
  };
  const checked = (exports: Exports, isMade: number): ArrayBuffer => {
    if (isMade !== 1) throw new Error(new TextDecoder().decode(result(exports)));
    return result(exports);
  };
  const withBytes = <Made>(exports: Exports, bytes: Uint8Array, use: (place: number) => Made): Made => {
    const place = exports.live_room(bytes.length + 1);
    if (place === 0) throw new Error("there is not enough memory for the motion core");
    try {
      new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
      return use(place);
    } finally {
      exports.live_leave(place);
    }
  };
  const withName = (exports: Exports, name: string, use: (place: number, size: number) => number) => {
    const bytes = text.encode(name);
    return withBytes(exports, bytes, (place) => use(place, bytes.length));
  };
  const set = (exports: Exports, setting: { kind: string; sliders: string[]; values: number[] }) => {
    const kind = ["adjectives", "features", "weights", "modifications"].indexOf(setting.kind);
    if (kind < 0) throw new Error(`there is no interface "${setting.kind}"`);
    if (setting.sliders.length !== setting.values.length) throw new Error("give one value a slider");
    exports.live_set(kind);
    setting.sliders.forEach((slider, i) => {
      withName(exports, slider, (place, size) => {
        exports.live_slider(place, size, setting.values[i]!);
        return 1;
      });
    });
  };

  const open = async (module: ArrayBuffer, bundle: ArrayBuffer): Promise<ArrayBuffer> => {
    const stop = () => {
      throw new Error("the motion core stopped");
    };
    const imports = {
      wasi_snapshot_preview1: new Proxy({}, { get: () => stop }),
      env: { emscripten_notify_memory_growth: () => undefined },
    };
    const { instance } = await WebAssembly.instantiate(module, imports as WebAssembly.Imports);
    const exports = instance.exports as unknown as Exports;
    exports._initialize();
    const bytes = new Uint8Array(bundle);
    const info = checked(exports, withBytes(exports, bytes, (place) => exports.live_open(place, bytes.length)));
    core = exports;
    return info;
  };

  return async (request) => {
    if (request.what === "open") return open(request.module, request.bundle);
    const exports = core;
    if (!exports) throw new Error("the motion core is not open");
    switch (request.what) {
      case "example":
        return checked(exports, withName(exports, request.name, exports.live_example));
      case "target":
        return checked(exports, withName(exports, request.name, exports.live_target));
      case "make":
        set(exports, request.setting);
        return checked(exports, exports.live_make());
      case "distance":
        set(exports, request.setting);
        return checked(exports, withName(exports, request.target, exports.live_distance));
    }
  };
}
