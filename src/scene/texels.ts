import type { TextureImage } from './assets.ts';

export interface Texels {
  /** RGBA bytes as stored, alpha not multiplied in; row 0 is v = 0. */
  readonly bytes: Uint8Array;
  readonly width: number;
  readonly height: number;
}

/** The texels of a decoded image. */
export function readTexels(image: TextureImage): Texels {
  const { width, height } = image;
  return { bytes: 'data' in image ? image.data : readBitmap(image), width, height };
}

/** Through WebGL: a 2D canvas keeps alpha multiplied in, which loses the colour of what is nearly transparent. */
function readBitmap(bitmap: ImageBitmap): Uint8Array {
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (gl === null) throw new Error('an image cannot be read: there is no WebGL 2');
  try {
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    const { FRAMEBUFFER, COLOR_ATTACHMENT0, TEXTURE_2D } = gl;
    gl.framebufferTexture2D(
      FRAMEBUFFER,
      COLOR_ATTACHMENT0,
      TEXTURE_2D,
      gl.getParameter(gl.TEXTURE_BINDING_2D),
      0,
    );
    if (gl.checkFramebufferStatus(FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
      throw new Error(`an image of ${bitmap.width} x ${bitmap.height} cannot be read by WebGL`);
    const bytes = new Uint8Array(4 * bitmap.width * bitmap.height);
    gl.readPixels(0, 0, bitmap.width, bitmap.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  } finally {
    // A page may hold a few contexts at a time only.
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}
