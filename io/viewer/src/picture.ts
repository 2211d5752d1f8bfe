// The view as a picture, with what a reader of the picture alone needs: title, instant, scale, legend.
import { css, mapped } from "./colours";
import type { Field } from "./fields";
import type { LegendText } from "./legend";

export interface PictureText {
  title: string;
  instant: string;
  scale: { pixels: number; text: string }; // CSS pixels
  field: Field;
  legend: LegendText;
  dark: boolean;
  labels: [string, number, number][]; // text, place of its middle on the left [CSS pixels]
}

export function png_of(picture: HTMLCanvasElement): Promise<Blob> {
  return new Promise((done, fail) => picture.toBlob((blob) => (blob ? done(blob) : fail(new Error("the picture is too large to save"))), "image/png"));
}

/// @param out  is drawn into, and resized where its size is another: both sides are even, as films need them
export function draw_picture(view: HTMLCanvasElement, text: PictureText, out = document.createElement("canvas")): HTMLCanvasElement {
  const ratio = view.width / Math.max(1, view.clientWidth);
  const [w, h] = [view.clientWidth, view.clientHeight];
  const top = 34;
  const foot = 62;
  const even = (pixels: number) => 2 * Math.ceil(0.5 * pixels);
  const [wide, high] = [even(w * ratio), even((h + top + foot) * ratio)];
  if (out.width !== wide) out.width = wide;
  if (out.height !== high) out.height = high;
  const c = out.getContext("2d")!;
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.textAlign = "left";
  const ink = text.dark ? "#e6e8e8" : "#1e2226";
  c.fillStyle = text.dark ? "#1c2024" : "#ffffff";
  c.fillRect(0, 0, w + 2, h + top + foot + 2);
  c.drawImage(view, 0, top, w, h);
  c.fillStyle = c.strokeStyle = ink;
  c.font = "600 15px system-ui, sans-serif";
  c.textBaseline = "middle";
  const instant = c.measureText(text.instant).width;
  c.fillText(text.title, 12, top / 2, Math.max(60, w - instant - 40));
  c.textAlign = "right";
  c.fillText(text.instant, w - 12, top / 2);
  c.textAlign = "left";
  c.font = "12px system-ui, sans-serif";
  for (const [label, x, y] of text.labels) if (x > 0 && x < w && y > 0 && y < h) c.fillText(label, x, top + y);
  const y = top + h + 16;
  c.lineWidth = 1;
  c.beginPath();
  c.moveTo(12, y - 4);
  c.lineTo(12, y + 4);
  c.lineTo(12 + text.scale.pixels, y + 4);
  c.lineTo(12 + text.scale.pixels, y - 4);
  c.stroke();
  c.fillText(text.scale.text, 20 + text.scale.pixels, y);
  draw_legend(c, text, Math.max(w - 320, w / 2), y, Math.min(300, w / 2 - 20));
  return out;
}

function draw_legend(c: CanvasRenderingContext2D, text: PictureText, x: number, y: number, width: number): void {
  const ink = c.fillStyle;
  if (text.field.kind === "names") {
    let at = x;
    for (const [name, colour] of text.legend.names) {
      if (at > x + width - 40) break;
      c.fillStyle = css(colour);
      c.fillRect(at, y - 6, 12, 12);
      c.fillStyle = ink;
      c.fillText(name, at + 17, y);
      at += 30 + c.measureText(name).width;
    }
    c.fillText(text.legend.what, x, y + 32);
    return;
  }
  for (let i = 0; i < 128; ++i) {
    c.fillStyle = css(mapped(text.field.kind, i / 127));
    c.fillRect(x + (i / 128) * width, y - 7, width / 128 + 0.6, 12);
  }
  c.fillStyle = ink;
  text.legend.ticks.forEach((tick, i, all) => {
    c.textAlign = i === 0 ? "left" : i === all.length - 1 ? "right" : "center";
    c.fillText(tick, x + (i / (all.length - 1)) * width, y + 15);
  });
  c.textAlign = "left";
  c.fillText(text.legend.what, x, y + 32);
}
