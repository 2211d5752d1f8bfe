// The animation as a film: pictures like those of the PNG, encoded by the browser (WebCodecs), laid into a WebM file.
import { ArrayBufferTarget, Muxer } from "webm-muxer";

const RATE = 25; // pictures a second
const LONGEST = 60; // [s] of a film: a longer one is quickened
const KEY_EVERY = 50; // pictures from which a player can start
const QUEUE = 6; // pictures that wait to be encoded
const BITS = 0.12; // a second and pixel: flat colours and thin lines stay sharp

interface Codec {
  name: string; // as the browser calls it
  track: string; // as WebM calls it
}
const CODECS: Codec[] = [{ name: "vp09.00.51.08", track: "V_VP9" }, { name: "vp8", track: "V_VP8" }];

/// The simulated time of each picture.   @param speed  simulated seconds a second
export function film_times(first: number, last: number, speed: number): number[] {
  const step = Math.max(speed, (last - first) / LONGEST) / RATE;
  const count = Math.ceil((last - first) / step);
  const times = Array.from({ length: count + 1 }, (_, k) => Math.min(last, first + k * step));
  return [...times, ...Array.from({ length: RATE }, () => last)]; // the end stays for a second
}

/// @param draw  draws a step into a sheet, which has the same size for all   @param going  told how far it is; false: the film ends here
/// @throws Error where this browser cannot encode films
export async function make_film(steps: number[], draw: (step: number, sheet: HTMLCanvasElement) => Promise<void>, going: (share: number) => boolean): Promise<Blob> {
  const sheet = document.createElement("canvas");
  let film: Film | null = null;
  const size = [0, 0];
  for (let k = 0; k < steps.length && going(k / steps.length); ++k) {
    await draw(steps[k]!, sheet);
    if (!film) {
      size.splice(0, 2, sheet.width, sheet.height);
      film = await start_film(sheet.width, sheet.height);
      if (!film) throw new Error("this browser cannot encode films (WebCodecs); Chrome 94, Firefox 130, Safari 16.4 or later can");
    }
    if (sheet.width !== size[0] || sheet.height !== size[1]) throw new Error("the window has changed its size");
    await film.add(sheet);
    if (k % 5 === 4) await new Promise((done) => setTimeout(done)); // the page answers meanwhile
  }
  if (!film) throw new Error("it was ended before its first picture");
  return film.end();
}

/// An empty film. Null where this browser cannot encode.
async function start_film(width: number, height: number): Promise<Film | null> {
  if (typeof VideoEncoder === "undefined") return null;
  for (const { name, track } of CODECS) {
    const config: VideoEncoderConfig = { codec: name, width, height, framerate: RATE, bitrate: Math.round(BITS * width * height * RATE), latencyMode: "quality" };
    const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
    if (supported) return new Film(config, track);
  }
  return null;
}

class Film {
  private readonly target = new ArrayBufferTarget();
  private readonly muxer;
  private readonly encoder: VideoEncoder;
  private failure: Error | null = null;
  private count = 0;

  constructor(config: VideoEncoderConfig, track: string) {
    this.muxer = new Muxer({ target: this.target, video: { codec: track, width: config.width, height: config.height, frameRate: RATE } });
    this.encoder = new VideoEncoder({
      output: (chunk, meta) => this.muxer.addVideoChunk(chunk, meta),
      error: (e) => (this.failure = e instanceof Error ? e : new Error(String(e))),
    });
    this.encoder.configure(config);
  }

  /// @pre the picture has the size of the film   @throws Error where the browser cannot encode it
  async add(picture: HTMLCanvasElement): Promise<void> {
    const microseconds = 1e6 / RATE;
    const frame = new VideoFrame(picture, { timestamp: this.count * microseconds, duration: microseconds });
    this.encoder.encode(frame, { keyFrame: this.count % KEY_EVERY === 0 });
    frame.close();
    this.count += 1;
    while (this.encoder.encodeQueueSize > QUEUE && !this.failure) await new Promise((done) => setTimeout(done, 4));
    if (this.failure) throw this.failure;
  }

  async end(): Promise<Blob> {
    await this.encoder.flush();
    if (this.failure) throw this.failure;
    this.encoder.close();
    this.muxer.finalize();
    return new Blob([this.target.buffer], { type: "video/webm" });
  }
}
