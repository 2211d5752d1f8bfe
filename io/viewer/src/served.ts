// A run that `scree view` serves: the same chunks as those of a report, fetched when they are shown.
import { ChunkSource, type Run } from "./source";

async function fetched(path: string): Promise<Response> {
  const reply = await fetch(path).catch(() => {
    throw new Error("scree view does not answer; it has ended");
  });
  if (!reply.ok) throw new Error((await reply.text()).trim() || `the server answers with ${reply.status}`);
  return reply;
}

export class ServedSource extends ChunkSource {
  static async open(): Promise<ServedSource> {
    return new ServedSource((await (await fetched("run.json")).json()) as Run);
  }

  protected async packed(name: string): Promise<Uint8Array> {
    return new Uint8Array(await (await fetched(name.replace("-", "/"))).arrayBuffer());
  }
}
