// The animation as a film: pictures like those of the PNG, encoded by the browser (WebCodecs), laid into a WebM file.
import { ArrayBufferTarget, Muxer } from "webm-muxer";

export const FILM_RATE = 25; // pictures a second
const KEY_EVERY = 50; // pictures from which a player can start
const QUEUE = 6; // pictures that wait to be encoded
const BITS = 0.12; // a second and pixel: flat colours and thin lines stay sharp

interface Codec {
  name: string; // as the browser calls it
  track: string; // as WebM calls it
}
const CODECS: Codec[] = [{ name: "vp09.00.51.08", track: "V_VP9" }, { name: "vp8", track: "V_VP8" }];

/// An empty film. Null where this browser cannot encode.
export async function start_film(width: number, height: number): Promise<Film | null> {
  if (typeof VideoEncoder === "undefined") return null;
  for (const { name, track } of CODECS) {
    const config: VideoEncoderConfig = { codec: name, width, height, framerate: FILM_RATE, bitrate: Math.round(BITS * width * height * FILM_RATE), latencyMode: "quality" };
    const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
    if (supported) return new Film(config, track);
  }
  return null;
}

export class Film {
  private readonly target = new ArrayBufferTarget();
  private readonly muxer;
  private readonly encoder: VideoEncoder;
  private failure: Error | null = null;
  private count = 0;

  constructor(config: VideoEncoderConfig, track: string) {
    this.muxer = new Muxer({ target: this.target, video: { codec: track, width: config.width, height: config.height, frameRate: FILM_RATE } });
    this.encoder = new VideoEncoder({
      output: (chunk, meta) => this.muxer.addVideoChunk(chunk, meta),
      error: (e) => (this.failure = e instanceof Error ? e : new Error(String(e))),
    });
    this.encoder.configure(config);
  }

  /// @pre the picture has the size of the film   @throws Error where the browser cannot encode it
  async add(picture: HTMLCanvasElement): Promise<void> {
    const microseconds = 1e6 / FILM_RATE;
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
