/** An object that people turn, drawn by the code that firmware links: `<lumi-view src="clock.lumi" spin>`. */
export class LumiView extends HTMLElement {
  /** Names of the parts that move. */
  readonly parts: string[];
  /** Turns a part by degrees, or slides it by radii of the sphere around the scene. */
  setPart(name: string, value: number): void;
  /** Shows the first view again, that of the attribute `orbit`. */
  goHome(): void;
}

export interface LumiViewEventMap {
  load: CustomEvent<{bytes: number}>;
  error: CustomEvent<{message: string}>;
  turn: CustomEvent<{azimuth: number, elevation: number}>;
}

declare global {
  interface HTMLElementTagNameMap {
    'lumi-view': LumiView;
  }
}
