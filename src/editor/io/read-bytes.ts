/** The bytes of a file, telling how far it is: files of hundreds of megabytes take a while. */
export async function readBytes(
  file: Blob,
  onProgress: (fraction: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(file.size);
  let at = 0;
  const reader = file.stream().getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    bytes.set(part.value, at);
    at += part.value.length;
    onProgress(at / file.size);
  }
  return bytes;
}
