/** The verdict on a model. */
import type { Catalogue } from '../catalogue.ts';

export const verdict: Catalogue = {
  'albedo up to {value}': 'albedo de hasta {value}',
  '{where}, the surface gives back {value} times the light that it receives: in a white room it would glow.':
    '{where}, la superficie devuelve {value} veces la luz que recibe: en una habitación blanca resplandecería.',
  'The surface gives back at most {value} of the light that it receives: it makes none.':
    'La superficie devuelve como mucho {value} de la luz que recibe: no crea ninguna.',
  "The header has no line 'lossless:', so the model does not claim to give back all light for any parameters.":
    "La cabecera no tiene una línea 'lossless:', así que el modelo no afirma devolver toda la luz con ningún parámetro.",
  'albedo {value}': 'albedo {value}',
  'In a furnace that glows white all over, the surface gives back {value} of the light {where}, where the header promises all of it.':
    'En un horno que brilla blanco por todas partes, la superficie devuelve {value} de la luz {where}, donde la cabecera la promete toda.',
  'In a furnace that glows white all over, the surface cannot be seen: it gives back exactly what it receives.':
    'En un horno que brilla blanco por todas partes, la superficie no se ve: devuelve exactamente lo que recibe.',
  'no jump': 'sin saltos',
  'Over {length} paths through directions and parameters nothing jumps: no hard edges in the picture, and sliders act smoothly.':
    'En {length} recorridos por direcciones y parámetros nada da saltos: no hay bordes duros en la imagen y los controles actúan con suavidad.',
  'jumps by {value}': 'salta {value}',
  '{term} jumps by {value} at one spot, {where}: the picture has a hard edge there, or a slider a step.':
    '{term} salta {value} en un punto, {where}: ahí la imagen tiene un borde duro, o un control un escalón.',
  "The header has no line 'distributions:', so no term is known to count facets.":
    "La cabecera no tiene una línea 'distributions:', así que de ningún término se sabe que cuente facetas.",
  'integral {value}': 'integral {value}',
  'The facets of {term}, seen from above, cover {value} of the surface, not 100 %: some are counted too often, or are missing.':
    'Las facetas de {term}, vistas desde arriba, cubren {value} de la superficie, no el 100 %: algunas se cuentan de más, o faltan.',
  'The tiny facets, seen from above, cover the surface exactly once: the distribution is normalised.':
    'Las facetas diminutas, vistas desde arriba, cubren la superficie exactamente una vez: la distribución está normalizada.',
  "The header has no line 'masking:', so no term is known to say which facets are seen from one side.":
    "La cabecera no tiene una línea 'masking:', así que de ningún término se sabe que diga qué facetas se ven desde un lado.",
  'The facets that {term} leaves to be seen cover {value} of the view {where}, not 100 %: masking and distribution do not belong to one surface.':
    'Las facetas que {term} deja ver cubren {value} de la vista {where}, no el 100 %: el enmascaramiento y la distribución no son de una misma superficie.',
  'Wherever one looks from, the facets that are seen cover the view exactly once: masking and distribution belong to one surface.':
    'Desde dondequiera que se mire, las facetas que se ven cubren la vista exactamente una vez: el enmascaramiento y la distribución son de una misma superficie.',
  'No GPU was asked; the lab asks its own, and the command does with --backend gpu.':
    'No se preguntó a ninguna GPU; el laboratorio pregunta a la suya, y la orden lo hace con --backend gpu.',
  'differs by {error}': 'difiere en {error}',
  'On the GPU {term} is off by {error} {where}: 32 bits are too few for its formula there.':
    'En la GPU, {term} se desvía {error} {where}: 32 bits son pocos para su fórmula ahí.',
  'The GPU, with half the digits, computes the same values: what you see is what was checked.':
    'La GPU, con la mitad de las cifras, calcula los mismos valores: lo que ves es lo que se comprobó.',
  'Every value is an ordinary number, even where light or view grazes the surface.':
    'Todos los valores son números normales, también donde la luz o la vista rozan la superficie.',
  '0 of {count} not finite': '0 de {count} no finitos',
  'is not a number': 'no es un número',
  'grows beyond what a GPU can hold': 'crece más de lo que cabe en una GPU',
  '{bad} of {count} not finite': '{bad} de {count} no finitos',
  '{name} {what} {where}: such a pixel turns black or white and spreads when blurred.':
    '{name} {what} {where}: un píxel así se vuelve negro o blanco y se extiende al desenfocarlo.',
  'none below 0': 'ninguno bajo 0',
  '{figure} /sr': '{figure} /sr',
  'The surface never takes away more light than there is: no value is negative.':
    'La superficie nunca quita más luz de la que hay: ningún valor es negativo.',
  '{term} is {figure} {where}: a surface cannot reflect less than no light.':
    '{term} es {figure} {where}: una superficie no puede reflejar menos que ninguna luz.',
  'Light and viewer can change places and nothing changes, as nature has it (Helmholtz).':
    'Luz y observador pueden cambiar de sitio y nada cambia, como en la naturaleza (Helmholtz).',
  '{term} changes by {value} when light and viewer change places, {where}: light traced from the lamp and light traced from the eye would give two different pictures.':
    '{term} cambia {value} cuando luz y observador cambian de sitio, {where}: la luz trazada desde la lámpara y la trazada desde el ojo darían dos imágenes distintas.',
  "The header has no line 'lobes:', so no terms are meant to add up to the model.":
    "La cabecera no tiene una línea 'lobes:', así que ningún término tiene que sumar el modelo con otros.",
  'The lobes {list} do not add up to BRDF: the sum is off by {value} {where}.':
    'Los lóbulos {list} no suman BRDF: la suma se desvía {value} {where}.',
  'Its {length} lobes add up to the model: light that one of them reflects is counted once.':
    'Sus {length} lóbulos suman el modelo: la luz que refleja uno de ellos se cuenta una vez.',
  'pdf is {value} {where}: no direction is less likely than impossible.':
    'pdf es {value} {where}: ninguna dirección es menos probable que imposible.',
  'integral up to {value}': 'integral de hasta {value}',
  'The probabilities of all directions together are {value}, not at most 100 %, {where}: pictures come out too dark.':
    'Las probabilidades de todas las direcciones suman {value}, no como mucho el 100 %, {where}: las imágenes salen demasiado oscuras.',
  'The probabilities of all directions together are at most 100 %; what lacks are samples below the surface.':
    'Las probabilidades de todas las direcciones suman como mucho el 100 %; lo que falta son muestras bajo la superficie.',
  'All lobes that were tried are narrower than the cells of the histogram.':
    'Todos los lóbulos que se probaron son más estrechos que las celdas del histograma.',
  'p = {pValue} in {done} tests': 'p = {pValue} en {done} pruebas',
  'sampleL does not choose directions as pdf says {where}: a path tracer would light this surface wrongly.':
    'sampleL no elige las direcciones como dice pdf {where}: un trazador de caminos iluminaría mal esta superficie.',
  'sampleL chooses directions as often as pdf says: a path tracer lights this surface rightly.':
    'sampleL elige las direcciones tantas veces como dice pdf: un trazador de caminos ilumina bien esta superficie.',
  'with the light at {light} and the viewer at {viewer} from the normal':
    'con la luz a {light} y el observador a {viewer} de la normal',
  'with the light at {light} from the normal': 'con la luz a {light} de la normal',
  'with the viewer at {viewer} from the normal': 'con el observador a {viewer} de la normal',
  'largest albedo': 'albedo máximo',
  'change when l and v swap': 'cambio al intercambiar l y v',
  'below the surface': 'bajo la superficie',
  'not of length 1': 'de longitud distinta de 1',
  'no light comes from there, and the sample should be given up as vec3(0)':
    'de ahí no viene luz, y la muestra debería darse por perdida como vec3(0)',
  'a direction is a unit vector': 'una dirección es un vector unitario',
  'sampleL gives directions that are {what} {where}: {note}.':
    'sampleL da direcciones {what} {where}: {note}.',
};
