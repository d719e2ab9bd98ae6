/** The shipped models and scenes. */
import type { Catalogue } from '../catalogue.ts';

export const models: Catalogue = {
  'Cook-Torrance: a rough surface of tiny mirrors over a matte base':
    'Cook-Torrance: una superficie rugosa de espejos diminutos sobre una base mate',
  multipleScatteringLobe: 'lóbulo de dispersión múltiple',
  withMultipleScattering: 'con dispersión múltiple',
  diffuseLobe: 'lóbulo difuso',
  specularLobe: 'lóbulo especular',
  distribution: 'distribución',
  fresnel: 'Fresnel',
  masking: 'enmascaramiento',
  viewMasking: 'enmascaramiento de la vista',
  'Colour of the matte base, and of the reflection where metallic. Linear Rec. 709.':
    'Color de la base mate, y del reflejo donde es metálica. Rec. 709 lineal.',
  kd: 'kd',
  'Balance between the base and its gloss: 0 only gloss, 1 only base.':
    'Equilibrio entre la base y su brillo: 0 solo brillo, 1 solo base.',
  Metallic: 'Metalicidad',
  '0 a dielectric (plastic, stone, wood), 1 a metal: all light is reflected at the surface, tinted by albedo.':
    '0 un dieléctrico (plástico, piedra, madera), 1 un metal: toda la luz se refleja en la superficie, teñida por el albedo.',
  Roughness: 'Rugosidad',
  'Root mean square slope of the facets: 0 mirror-like (acts as .001), 1 very rough.':
    'Pendiente cuadrática media de las facetas: 0 como un espejo (actúa como .001), 1 muy rugosa.',
  IOR: 'Índice de refracción',
  'Index of refraction: 1 air (no reflection head-on), 1.33 water, 1.5 glass, 2.42 diamond.':
    'Índice de refracción: 1 aire (sin reflejo de frente), 1.33 agua, 1.5 vidrio, 2.42 diamante.',
  'Glass, water, gems: a rough boundary of a transparent body, which reflects and refracts':
    'Vidrio, agua, gemas: la interfaz rugosa de un cuerpo transparente, que refleja y refracta',
  reflection: 'reflexión',
  refraction: 'refracción',
  'Index of refraction of the body: 1.33 water, 1.5 glass, 1.77 sapphire, 2.42 diamond.':
    'Índice de refracción del cuerpo: 1.33 agua, 1.5 vidrio, 1.77 zafiro, 2.42 diamante.',
  "0 clear, 1 frosted. The facets' width alpha is its square.":
    '0 transparente, 1 esmerilado. La anchura alfa de las facetas es su cuadrado.',
  'Transmission color': 'Color de transmisión',
  'What is left of white light after transmissionDepth inside. Linear Rec. 709.':
    'Lo que queda de la luz blanca tras recorrer transmissionDepth por dentro. Rec. 709 lineal.',
  'Transmission depth': 'Profundidad de transmisión',
  'The way after which transmissionColor is left, in m; 0 is a clear body.':
    'El recorrido tras el que queda transmissionColor, en m; 0 es un cuerpo incoloro.',
  Scatter: 'Dispersión interna',
  'Light scattered inside, over the same way: 0 is clear, much is milky.':
    'Luz que se dispersa por dentro en el mismo recorrido: 0 es transparente, mucha es lechoso.',
  'Scatter anisotropy': 'Anisotropía de la dispersión',
  'Scattering backward (-), evenly (0) or forward (+).':
    'Dispersión hacia atrás (-), por igual (0) o hacia delante (+).',
  "Lambert's law": 'Ley de Lambert',
  'The share of the light that is reflected, per colour: 0 black, 1 everything. Linear Rec. 709.':
    'La parte de la luz que se refleja, por color: 0 negro, 1 toda. Rec. 709 lineal.',
  "The principled model with light that passes through: Disney's model of 2012 grown into a BSDF":
    'El modelo principled con luz que atraviesa: el modelo de Disney de 2012 convertido en una BSDF',
  sheenLobe: 'lóbulo aterciopelado',
  clearcoatLobe: 'lóbulo del barniz',
  transmissionLobe: 'lóbulo de transmisión',
  'Base color': 'Color base',
  "The surface's colour; of clear bodies what two passes through the surface leave. Linear Rec. 709.":
    'El color de la superficie; en cuerpos transparentes, lo que dejan dos pasos por la superficie. Rec. 709 lineal.',
  '0 a dielectric, 1 a metal, which lets nothing through.':
    '0 un dieléctrico, 1 un metal, que no deja pasar nada.',
  "0 mirror-like and clear, 1 fully rough. The facets' width alpha is its square.":
    '0 como un espejo y transparente, 1 del todo rugosa. La anchura alfa de las facetas es su cuadrado.',
  Anisotropic: 'Anisotropía',
  'Stretches the highlight along the tangent: 0 round, 1 ten times as long as wide.':
    'Estira el brillo a lo largo de la tangente: 0 redondo, 1 diez veces más largo que ancho.',
  'Index of refraction of the body: 1.33 water, 1.5 glass, 2.42 diamond.':
    'Índice de refracción del cuerpo: 1.33 agua, 1.5 vidrio, 2.42 diamante.',
  'Specular tint': 'Tinte especular',
  "Tints the dielectric's reflection: 0 white, 1 the hue of the base colour.":
    'Tiñe el reflejo del dieléctrico: 0 blanco, 1 el tono del color base.',
  Sheen: 'Brillo aterciopelado',
  'A glow at grazing angles, as of fuzz on cloth.':
    'Un resplandor en ángulos rasantes, como el de la pelusa de una tela.',
  'Sheen tint': 'Tinte del brillo aterciopelado',
  'Tints the sheen: 0 white, 1 the hue of the base colour.':
    'Tiñe el brillo aterciopelado: 0 blanco, 1 el tono del color base.',
  Clearcoat: 'Barniz',
  'A second, colourless reflection on top, as of varnish.':
    'Un segundo reflejo, incoloro, por encima, como el de un barniz.',
  'Clearcoat gloss': 'Brillo del barniz',
  'Sharpness of the clearcoat: 0 satin, 1 gloss.': 'Nitidez del barniz: 0 satinado, 1 brillante.',
  'Spec trans': 'Transmisión especular',
  'How much of the base lets light through: 0 opaque, 1 glass.':
    'Cuánta luz deja pasar la base: 0 opaca, 1 vidrio.',
  'Diff trans': 'Transmisión difusa',
  "Of a thin sheet's diffuse light, what goes through it: 0 none, .5 as much as comes back (paper, leaves).":
    'De la luz difusa de una lámina delgada, la que la atraviesa: 0 ninguna, .5 tanta como vuelve (papel, hojas).',
  Thin: 'Delgada',
  'A sheet, as a leaf or a pane, that encloses nothing and bends no ray.':
    'Una lámina, como una hoja o un cristal de ventana, que no encierra nada y no desvía ningún rayo.',
  'Light scattered inside, over the same way: 0 is clear, much is milk, wax or skin.':
    'Luz que se dispersa por dentro en el mismo recorrido: 0 es transparente, mucha es leche, cera o piel.',
  'The principled model as the thesis writes it': 'El modelo principled como lo escribe la tesis',
  subsurfaceLobe: 'lóbulo subsuperficial',
  clearcoatDistribution: 'distribución del barniz',
  "The surface's colour: of the base where metallic is 0, of the reflection where it is 1. Linear Rec. 709.":
    'El color de la superficie: de la base donde metallic es 0, del reflejo donde es 1. Rec. 709 lineal.',
  Subsurface: 'Dispersión subsuperficial',
  'Flattens the diffuse shading like light that scatters below the surface: 0 none (paint), 1 full (skin, wax).':
    'Aplana el sombreado difuso como luz que se dispersa bajo la superficie: 0 nada (pintura), 1 del todo (piel, cera).',
  '0 a dielectric: coloured base, colourless reflection. 1 a metal: no base, reflection times the base colour.':
    '0 un dieléctrico: base de color, reflejo incoloro. 1 un metal: sin base, reflejo por el color base.',
  Specular: 'Especular',
  'Index of refraction of the surface, 1 + .8 specular: 0 no reflection head-on, .5 is 1.4 (2.8 %), 1 is 1.8 (8 %).':
    'Índice de refracción de la superficie, 1 + .8 specular: 0 sin reflejo de frente, .5 es 1.4 (2.8 %), 1 es 1.8 (8 %).',
  "Tints the dielectric's whole reflection: 0 white, 1 the base colour.":
    'Tiñe todo el reflejo del dieléctrico: 0 blanco, 1 el color base.',
  "0 mirror-like, 1 fully rough. The facets' width alpha is its square, so that equal steps look equal.":
    '0 como un espejo, 1 del todo rugosa. La anchura alfa de las facetas es su cuadrado, para que pasos iguales parezcan iguales.',
  'Stretches the highlight along the tangent: 0 round, 1 ten times as long as wide (brushed metal).':
    'Estira el brillo a lo largo de la tangente: 0 redondo, 1 diez veces más largo que ancho (metal cepillado).',
  'A glow at grazing angles, as of fuzz on cloth: 0 none, 1 full.':
    'Un resplandor en ángulos rasantes, como el de la pelusa de una tela: 0 ninguno, 1 del todo.',
  'Tints the sheen: 0 white, 1 the base colour.': 'Tiñe el brillo aterciopelado: 0 blanco, 1 el color base.',
  'A second, colourless reflection on top, as of varnish: 0 none, 1 full (a quarter of a real layer of ior 1.5).':
    'Un segundo reflejo, incoloro, por encima, como el de un barniz: 0 ninguno, 1 del todo (una cuarta parte de una capa real de índice 1.5).',
  'The principled model of Walt Disney Animation Studios':
    'El modelo principled de Walt Disney Animation Studios',
  '0 a dielectric: coloured base, colourless reflection. 1 a metal: no base, reflection in the base colour.':
    '0 un dieléctrico: base de color, reflejo incoloro. 1 un metal: sin base, reflejo en el color base.',
  "Strength of the dielectric's reflection, 0 to 8 % head-on: .5 is 4 % (ior 1.5, most materials), 1 is ior 1.8.":
    'Intensidad del reflejo del dieléctrico, de 0 a 8 % de frente: .5 es 4 % (índice 1.5, la mayoría de los materiales), 1 es índice 1.8.',
  "Tints the dielectric's head-on reflection: 0 white, 1 the hue of the base colour.":
    'Tiñe el reflejo de frente del dieléctrico: 0 blanco, 1 el tono del color base.',
  Thesis: 'La tesis',
  Polygons: 'Polígonos',
  'Principled parameters': 'Parámetros de principled',
  'Thesis demo02': 'Demo 02 de la tesis',
  'The scene of the thesis: a camera of 75 degrees and five lights, one ambient, two directional of which one is red, one point and one spot; Suzanne and the primitives, in Cook-Torrance and Principled materials.':
    'La escena de la tesis: una cámara de 75 grados y cinco luces, una ambiental, dos direccionales de las que una es roja, una puntual y un foco; Suzanne y las primitivas, en materiales Cook-Torrance y Principled.',
  'Figure 6.2 of the thesis: twenty spheres; from left to right each row goes from 0 to 1 in one parameter of the Principled model: roughness (red, specular 1), subsurface (green), clearcoat (blue, gloss 1), sheen (grey, sheenTint 1).':
    'Figura 6.2 de la tesis: veinte esferas; de izquierda a derecha cada fila va de 0 a 1 en un parámetro del modelo Principled: rugosidad (rojo, specular 1), subsurface (verde), barniz (azul, gloss 1), brillo aterciopelado (gris, sheenTint 1).',
  'Figure 6.1 of the thesis: five spheres with the Principled model. The thesis has about 8 million polygons for each; here they have 200 704, so that a computer without a graphics card can show them too. Raise the segments of a sphere to 2048 x 2048 for as many as the thesis has.':
    'Figura 6.1 de la tesis: cinco esferas con el modelo Principled. La tesis tiene unos 8 millones de polígonos por esfera; aquí tienen 200 704, para que también pueda mostrarlas un ordenador sin tarjeta gráfica. Sube los segmentos de una esfera a 2048 x 2048 para tener tantos como la tesis.',
  'Figure 4.19 of the thesis: one row per parameter of the Principled model, from 0 at the left to 1 at the right. From the top: subsurface, metallic, specular, specularTint, roughness, anisotropic, sheen, sheenTint, clearcoat, clearcoatGloss.':
    'Figura 4.19 de la tesis: una fila por parámetro del modelo Principled, de 0 a la izquierda a 1 a la derecha. Desde arriba: subsurface, metallic, specular, specularTint, roughness, anisotropic, sheen, sheenTint, clearcoat, clearcoatGloss.',
  'The published demo of the thesis: a floor, a wall, a cube, a sphere and a cone under a red, a green and a blue spot light that add up to white.':
    'La demo publicada de la tesis: un suelo, una pared, un cubo, una esfera y un cono bajo un foco rojo, uno verde y uno azul que suman blanco.',
};
