/** Cloth: warp threads along v go over and under weft threads along u. One up one down is plain weave, three and one is twill. */
import { color } from '../fields.ts';
import { count, kind, paint, share } from './kind.ts';
import { clamp, gradientNoise, modulo, random, smoothstep } from './noise.ts';

export const weave = kind({
  title: 'Weave',
  shape: {
    repeats: count('How often the weave is repeated across the picture', 1, 64),
    over: count('Weft threads that a warp thread passes over', 1, 8),
    under: count('Weft threads that it then passes under', 1, 8),
    weftColor: color('Colour of the weft threads, linear Rec. 709'),
    thickness: share('How much of the cloth the threads fill'),
    irregularity: share('How unequal the threads are'),
    fibre: share('How much the single fibres show'),
  },
  defaults: {
    repeats: 16,
    over: 1,
    under: 1,
    weftColor: [0.5, 0.5, 0.5],
    thickness: 0.8,
    irregularity: 0.4,
    fibre: 0.5,
  },
  // A thread is about as high as it is wide; two cross.
  depth: ({ repeats, over, under }) => 0.7 / (repeats * (over + under)),
  sampler(settings) {
    const { repeats, over, under, weftColor, thickness, irregularity, fibre } = settings;
    const { seed, color: warpColor } = settings;
    const period = over + under;
    const threads = repeats * period;
    const halfThreads = Math.ceil(threads / 2);
    const half = 0.3 + 0.2 * thickness;
    const isUp = (warp: number, weft: number): boolean => modulo(warp - weft, period) < over;
    /** How high a thread is on its way, -1..1: it changes sides where threads of the other kind end. */
    const way = (before: boolean, here: boolean, after: boolean, at: number): number => {
      const side = here ? 1 : -1;
      const other = at < 0.5 ? before : after;
      return other === here ? side : side * (1 - smoothstep(0.1, 0.5, Math.abs(at - 0.5)));
    };
    /** 1 on the ridge of a thread, 0 at its edge; negative beside it. */
    const round = (at: number, width: number): number => {
      const x = (at - 0.5) / (half * width);
      return 1 - x * x;
    };
    return (u, v, out) => {
      const bend = 0.12 * irregularity;
      const x =
        u * threads + bend * gradientNoise(u * threads, v * halfThreads, threads, halfThreads, seed + 1);
      const y =
        v * threads + bend * gradientNoise(u * halfThreads, v * threads, halfThreads, threads, seed + 2);
      const warp = Math.floor(x);
      const weft = Math.floor(y);
      const fx = x - warp;
      const fy = y - weft;
      const up = isUp(warp, weft);
      const i = modulo(warp, threads);
      const j = modulo(weft, threads);
      const thick = (thread: number, of: number) =>
        1 + 0.25 * irregularity * (random(thread, of, seed) - 0.5);
      const warpRound = round(fx, thick(i, 1));
      const weftRound = round(fy, thick(j, 2));
      const warpHeight =
        warpRound > 0
          ? way(isUp(warp, weft - 1), up, isUp(warp, weft + 1), fy) + 0.9 * Math.sqrt(warpRound)
          : -2;
      const weftHeight =
        weftRound > 0
          ? way(!isUp(warp - 1, weft), !up, !isUp(warp + 1, weft), fx) + 0.9 * Math.sqrt(weftRound)
          : -2;
      const isWarp = warpHeight > weftHeight;
      const height = clamp((Math.max(warpHeight, weftHeight) + 2) / 3.9);
      const n = 8 * threads;
      // Fibres are spun: they lie askew along the thread.
      const spun = isWarp
        ? gradientNoise((u + v) * n, v * threads, n, threads, seed + 3)
        : gradientNoise(u * threads, (v + u) * n, threads, n, seed + 4);
      const thread = 1 + 0.5 * irregularity * (random(isWarp ? i : j, isWarp ? 3 : 4, seed) - 0.5);
      // Light reaches less of what lies deep between threads.
      paint(isWarp ? warpColor : weftColor, thread * (1 + 0.35 * fibre * spun) * (0.35 + 0.65 * height), out);
      out.height = clamp(height + 0.04 * fibre * spun);
      out.roughness = 1.1 - 0.2 * height;
    };
  },
});
