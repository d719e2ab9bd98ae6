/** Fields of the document: labels, choices, descriptions. */
import type { Catalogue } from '../catalogue.ts';

export const schema: Catalogue = {
  Shadows: 'Sombras',
  'Contact shadows': 'Sombras de contacto',
  Reflections: 'Reflejos',
  'Indirect light': 'Luz indirecta',
  Antialiasing: 'Suavizado de bordes',
  'Depth of field': 'Profundidad de campo',
  'Motion blur': 'Desenfoque de movimiento',
  Bloom: 'Resplandor',
  Lens: 'Lente',
  'Things keep the light of lamps off what is behind them':
    'Los objetos tapan la luz de las lámparas a lo que hay detrás',
  Enabled: 'Activado',
  'Points along each side of a map of what a lamp sees; more makes fine shadows sharp':
    'Puntos por lado del mapa de lo que ve una lámpara; con más, las sombras finas son nítidas',
  'Points that are looked at for each pixel and lamp; more makes soft shadows smooth':
    'Puntos que se miran por píxel y lámpara; con más, las sombras suaves lo son de verdad',
  'Maps of each directional light: the nearest shows the finest shadows':
    'Mapas de cada luz direccional: el más cercano muestra las sombras más finas',
  Cascades: 'Cascadas',
  'Directional lights’ maps are for what is nearer to the camera than this':
    'Los mapas de las luces direccionales son para lo que está más cerca de la cámara que esto',
  'Max distance': 'Distancia máxima',
  'Light from everywhere is weaker in corners and under things, where it cannot reach':
    'La luz de todas partes es más débil en los rincones y bajo los objetos, adonde no llega',
  'What is farther away than this keeps no light off': 'Lo que está más lejos que esto no tapa la luz',
  Radius: 'Radio',
  'How far things go on behind what the camera sees of them':
    'Hasta dónde siguen los objetos por detrás de lo que ve la cámara',
  Thickness: 'Grosor',
  'Light that bounces in a corner tints it: bright colours lose less than dark ones':
    'La luz que rebota en un rincón lo tiñe: los colores claros pierden menos que los oscuros',
  Bounces: 'Rebotes',
  'Directions on the screen in which a pixel looks; more is smoother':
    'Direcciones de la pantalla en las que mira un píxel; con más es más suave',
  Directions: 'Direcciones',
  'Places that a pixel looks at each way; more finds smaller things':
    'Lugares que mira un píxel hacia cada lado; con más encuentra objetos más pequeños',
  'Computed at half the width and height: a quarter of the cost, slightly softer':
    'Se calcula a la mitad de anchura y de altura: una cuarta parte del coste, algo más blando',
  'Half resolution': 'Media resolución',
  'Short shadows where things touch, found in the picture itself; too fine for shadow maps':
    'Sombras cortas donde los objetos se tocan, buscadas en la propia imagen; demasiado finas para los mapas de sombras',
  'How far towards the light a pixel looks': 'Hasta dónde mira un píxel hacia la luz',
  Length: 'Longitud',
  'Places on the way that are looked at; more finds finer things':
    'Lugares del camino que se miran; con más encuentra objetos más finos',
  'Glossy surfaces reflect what the picture shows; where it shows nothing, the environment':
    'Las superficies brillantes reflejan lo que muestra la imagen; donde no muestra nada, el entorno',
  'Rays for each pixel and frame; more is smoother while things move':
    'Rayos por píxel y fotograma; con más es más suave mientras algo se mueve',
  Rays: 'Rayos',
  'Places that are looked at along a ray; more finds smaller things':
    'Lugares que se miran a lo largo de un rayo; con más encuentra objetos más pequeños',
  'Traced at half the width and height: a quarter of the cost, slightly softer':
    'Se traza a la mitad de anchura y de altura: una cuarta parte del coste, algo más blando',
  'Frames are gathered over time and neighbours share what they find':
    'Los fotogramas se acumulan en el tiempo y los vecinos comparten lo que encuentran',
  'Surfaces light each other: light that bounces between what the picture shows, and colours that it takes along':
    'Las superficies se iluminan unas a otras: luz que rebota entre lo que muestra la imagen, y los colores que se lleva',
  'The scene’s fog is seen, and lamps shine through it in shafts':
    'Se ve la niebla de la escena, y las lámparas la atraviesan en haces',
  'Places in the air that are looked at for each pixel and lamp; more makes shafts smooth':
    'Lugares del aire que se miran por píxel y lámpara; con más, los haces son más suaves',
  'Against jagged edges: four samples a pixel (MSAA); frames gathered over time, the best when nothing moves; edges of the finished picture found and smoothed, carefully (SMAA) or quickly (FXAA)':
    'Contra los bordes dentados: cuatro muestras por píxel (MSAA); fotogramas acumulados en el tiempo, lo mejor cuando nada se mueve; bordes de la imagen acabada que se buscan y suavizan, con cuidado (SMAA) o deprisa (FXAA)',
  MSAA: 'MSAA',
  Temporal: 'Temporal',
  SMAA: 'SMAA',
  FXAA: 'FXAA',
  Method: 'Método',
  'What is not in focus is blurred, as the camera’s f-number and focus say':
    'Lo que no está enfocado se desenfoca, según el número f y el enfoque de la cámara',
  'How often the aperture is sampled; more is smoother where the blur is wide':
    'Cuántas veces se muestrea la apertura; con más es más suave donde el desenfoque es ancho',
  'What moves is blurred along its way while the camera’s shutter is open':
    'Lo que se mueve se desenfoca a lo largo de su camino mientras el obturador está abierto',
  'Places along the way that are looked at; more is smoother':
    'Lugares del camino que se miran; con más es más suave',
  'Glow around what is bright, as lenses and eyes make it':
    'Halo en torno a lo brillante, como lo hacen las lentes y los ojos',
  'Part of the light that is spread out; none is added or lost':
    'Parte de la luz que se esparce; no se añade ni se pierde ninguna',
  Strength: 'Intensidad',
  'How far the light is spread: 0 is close by, 1 is all over the picture':
    'Hasta dónde se esparce la luz: 0 es muy cerca, 1 es por toda la imagen',
  'Faults of a real lens': 'Defectos de una lente real',
  'Coloured fringes that grow towards the edges: how far red and blue are apart there':
    'Franjas de color que crecen hacia los bordes: cuánto se separan allí el rojo y el azul',
  Dispersion: 'Dispersión',
  'Dust and smears on the glass, seen where bright things glow through them':
    'Polvo y manchas en el cristal, que se ven donde brilla algo a través de ellos',
  Dirt: 'Suciedad',
  'Corners get less light: 1 is the cosine’s fourth power of a simple lens':
    'Las esquinas reciben menos luz: 1 es la cuarta potencia del coseno, la de una lente simple',
  Vignette: 'Viñeteado',
  'Where the sun stands, from north (-z) by east (+x)':
    'Dónde está el sol, desde el norte (-z) hacia el este (+x)',
  Azimuth: 'Acimut',
  'How high the sun stands; below 0 it has set': 'A qué altura está el sol; por debajo de 0 se ha puesto',
  Elevation: 'Elevación',
  'North of the equator': 'Al norte del ecuador',
  Latitude: 'Latitud',
  'East of Greenwich': 'Al este de Greenwich',
  Longitude: 'Longitud geográfica',
  'What a clock there shows, in hours since midnight':
    'Lo que marca allí un reloj, en horas desde medianoche',
  Time: 'Hora',
  'By how much that clock is ahead of UTC': 'Cuánto adelanta ese reloj a la hora UTC',
  'UTC offset': 'Diferencia con UTC',
  'Where its middle is seen, from north (-z) by east (+x)':
    'Dónde se ve su centro, desde el norte (-z) hacia el este (+x)',
  'How high its middle is seen': 'A qué altura se ve su centro',
  'The angle that it fills from side to side': 'El ángulo que ocupa de lado a lado',
  'The angle that it fills from its lower to its upper edge':
    'El ángulo que ocupa del borde inferior al superior',
  'By how much it is turned about the line of sight': 'Cuánto está girada en torno a la línea de visión',
  Roll: 'Giro',
  'The part of its half that fades towards the edge': 'La parte de su mitad que se desvanece hacia el borde',
  Softness: 'Suavidad',
  'Colour of its light, linear Rec. 709': 'Color de su luz, Rec. 709 lineal',
  Color: 'Color',
  'Colour as the temperature of a glowing body, times the colour':
    'Color como temperatura de un cuerpo incandescente, por el color',
  Temperature: 'Temperatura',
  'Luminance of its middle': 'Luminancia de su centro',
  Hdr: 'HDR',
  Sky: 'Cielo',
  Studio: 'Estudio',
  'Colour of the light that comes from everywhere, linear Rec. 709':
    'Color de la luz que viene de todas partes, Rec. 709 lineal',
  'An equirectangular HDR or EXR image': 'Una imagen HDR o EXR equirrectangular',
  Asset: 'Archivo',
  'An environment that comes with Irradia': 'Un entorno que viene con Irradia',
  Apartment: 'Apartamento',
  Bridge: 'Puente',
  City: 'Ciudad',
  Dawn: 'Alba',
  Esplanade: 'Explanada',
  Forest: 'Bosque',
  Hall: 'Salón',
  Lab: 'Laboratorio',
  Lobby: 'Vestíbulo',
  Night: 'Noche',
  Park: 'Parque',
  Sunrise: 'Amanecer',
  Sunset: 'Atardecer',
  Venice: 'Venecia',
  Warehouse: 'Almacén',
  Workshop: 'Taller',
  'Optical thickness of air and haze over that of air alone: 1 is air without haze, 2 a clear day, 5 and more a hazy one':
    'Espesor óptico del aire y la calima respecto al del aire solo: 1 es aire sin calima, 2 un día claro, de 5 en adelante uno brumoso',
  Turbidity: 'Turbidez',
  'What the ground beyond the scene reflects, linear Rec. 709':
    'Lo que refleja el suelo más allá de la escena, Rec. 709 lineal',
  'Ground color': 'Color del suelo',
  'By how much sky and sun are brighter than on Earth, where the noon sun gives 100 000 lx; at -15 white paper in it has about 1 nit':
    'Cuánto más brillantes son el cielo y el sol que en la Tierra, donde el sol del mediodía da 100 000 lx; con -15, un papel blanco tiene 1 nit aproximadamente',
  'Luminance of the room around the soft boxes': 'Luminancia de la sala que rodea las cajas de luz',
  Dome: 'Cúpula',
  'Colour of the room, linear Rec. 709': 'Color de la sala, Rec. 709 lineal',
  'Dome color': 'Color de la cúpula',
  'Luminance of a white texel': 'Luminancia de un téxel blanco',
  Intensity: 'Intensidad',
  'Rotation of the environment about the vertical': 'Rotación del entorno en torno a la vertical',
  Rotation: 'Rotación',
  'Directions per pixel from which its light is gathered':
    'Direcciones por píxel desde las que se recoge su luz',
  Transparent: 'Transparente',
  'Colour behind the scene, linear Rec. 709': 'Color detrás de la escena, Rec. 709 lineal',
  'How far the environment is out of focus': 'Cuánto está desenfocado el entorno',
  Blur: 'Desenfoque',
  'Shadow catcher': 'Recoge sombras',
  'Shows the shadows of the objects on a level ground that is itself not seen: the background is darker where they keep light off':
    'Muestra las sombras de los objetos en un suelo llano que no se ve: el fondo es más oscuro donde los objetos tapan la luz',
  'How high the ground lies; off, it is where the lowest of the visible objects touches it':
    'A qué altura está el suelo; sin número, donde lo toca el más bajo de los objetos visibles',
  'How far it reaches around the middle of the objects; 0 has no end':
    'Hasta dónde llega en torno al centro de los objetos; con 0 no acaba',
  'The part of the radius over which the shadows fade towards the rim':
    'La parte del radio en la que las sombras se desvanecen hacia el borde',
  Fade: 'Desvanecimiento',
  'How much of the shadows is shown; 1 is all of them': 'Cuánto se ve de las sombras; con 1, todo',
  Plane: 'Plano',
  Circle: 'Círculo',
  Box: 'Caja',
  Cone: 'Cono',
  Cylinder: 'Cilindro',
  Torus: 'Toro',
  Suzanne: 'Suzanne',
  Gltf: 'glTF',
  'Size along x': 'Tamaño a lo largo de x',
  'Size along y': 'Tamaño a lo largo de y',
  'Divisions along x': 'Divisiones a lo largo de x',
  'Width segments': 'Segmentos de anchura',
  'Divisions along y': 'Divisiones a lo largo de y',
  'Height segments': 'Segmentos de altura',
  'Distance from the centre to the edge': 'Distancia del centro al borde',
  'Divisions around the centre': 'Divisiones en torno al centro',
  Segments: 'Segmentos',
  'Angle at which the shape begins': 'Ángulo en el que empieza la forma',
  'Theta start': 'Inicio de theta',
  'Angle that the shape covers; 360 is the whole': 'Ángulo que abarca la forma; 360 es entera',
  'Theta length': 'Amplitud de theta',
  'Size along z': 'Tamaño a lo largo de z',
  Depth: 'Profundidad',
  'Divisions along z': 'Divisiones a lo largo de z',
  'Depth segments': 'Segmentos de profundidad',
  'Radius of the base': 'Radio de la base',
  'From the base to the tip': 'De la base a la punta',
  'Divisions around the axis': 'Divisiones en torno al eje',
  'Radial segments': 'Segmentos radiales',
  'Divisions along the height': 'Divisiones a lo largo de la altura',
  'Without the caps at the ends': 'Sin las tapas de los extremos',
  'Open ended': 'Sin tapas',
  'Radius of the upper end': 'Radio del extremo superior',
  'Radius top': 'Radio superior',
  'Radius of the lower end': 'Radio del extremo inferior',
  'Radius bottom': 'Radio inferior',
  'From end to end': 'De extremo a extremo',
  'From the centre of the ring to the centre of the tube': 'Del centro del anillo al centro del tubo',
  'Radius of the tube': 'Radio del tubo',
  Tube: 'Tubo',
  'Divisions around the tube': 'Divisiones en torno al tubo',
  'Divisions along the ring': 'Divisiones a lo largo del anillo',
  'Tubular segments': 'Segmentos del tubo',
  'Angle that the ring covers; 360 is the whole': 'Ángulo que abarca el anillo; 360 es entero',
  Arc: 'Arco',
  'Divisions from pole to pole': 'Divisiones de polo a polo',
  'The glTF file': 'El archivo glTF',
  'Index of the node in the file': 'Índice del nodo en el archivo',
  Node: 'Nodo',
  'Index of the primitive in the node’s mesh': 'Índice de la primitiva en la malla del nodo',
  Primitive: 'Primitiva',
  'Shown in the outliner': 'Se muestra en el esquema',
  'The group that this one is in': 'El grupo en el que está este',
  Parent: 'Grupo superior',
  'Whether it is kept from being picked in the picture, moved and deleted':
    'Si está protegido de que se elija en la imagen, se mueva o se elimine',
  Locked: 'Bloqueado',
  'The group that it is in': 'El grupo en el que está',
  Ambient: 'Ambiental',
  Hemisphere: 'Hemisférica',
  Directional: 'Direccional',
  Point: 'Puntual',
  Spot: 'Foco',
  Rectangle: 'Rectángulo',
  'Whether the light shines': 'Si la luz está encendida',
  Visible: 'Visible',
  'Colour of the light, linear Rec. 709; its brightness is a field of its own':
    'Color de la luz, Rec. 709 lineal; su brillo es un campo aparte',
  'Colour temperature of a black body; multiplies the colour':
    'Temperatura de color de un cuerpo negro; multiplica el color',
  'Radiance of every direction that the light comes from':
    'Radiancia de cada dirección de la que viene la luz',
  'Colour of the light that comes from below, linear Rec. 709':
    'Color de la luz que viene de abajo, Rec. 709 lineal',
  'Illuminance of a surface that faces the light': 'Iluminancia de una superficie orientada hacia la luz',
  'Where the light is': 'Dónde está la luz',
  Position: 'Posición',
  'The point that the light looks at': 'El punto al que mira la luz',
  'Angle that the light fills in the sky: how soft its shadows are. The sun’s is 0.53°':
    'Ángulo que ocupa la luz en el cielo: lo suaves que son sus sombras. El del Sol es de 0.53°',
  'Angular diameter': 'Diámetro angular',
  'Whether things keep its light off what is behind them': 'Si los objetos tapan su luz a lo que hay detrás',
  'Cast shadow': 'Proyecta sombra',
  'Luminous intensity along the light’s axis': 'Intensidad luminosa a lo largo del eje de la luz',
  'How the light fades with distance: inverse square is physics; linear and constant are not':
    'Cómo se atenúa la luz con la distancia: el inverso del cuadrado es lo físico; lineal y constante no lo son',
  'Inverse square': 'Inverso del cuadrado',
  Linear: 'Lineal',
  Falloff: 'Atenuación',
  'Distance at which the light has faded to nothing; 0 never cuts it off':
    'Distancia a la que la luz se ha atenuado del todo; 0 no la corta nunca',
  Range: 'Alcance',
  'Radius of the lamp: how soft its shadows are. What is lit wholly is lit as from its centre':
    'Radio de la lámpara: lo suaves que son sus sombras. Lo que ilumina entera recibe la luz como desde su centro',
  'Angle between the axis and the edge of the cone; no light beyond it':
    'Ángulo entre el eje y el borde del cono; más allá no hay luz',
  Cutoff: 'Ángulo de corte',
  's in I = I_max cos^s of the angle to the axis: larger is a tighter beam':
    's en I = I_max cos^s del ángulo con el eje: cuanto mayor, más estrecho el haz',
  Exponent: 'Exponente',
  'Part of the cone, from the edge inwards, over which the light fades in':
    'Parte del cono, desde el borde hacia dentro, en la que la luz aparece poco a poco',
  Penumbra: 'Penumbra',
  'Width of the panel': 'Anchura del panel',
  'Height of the panel': 'Altura del panel',
  'The image, or the glTF file that holds it': 'La imagen, o el archivo glTF que la contiene',
  'Index of the texture in a glTF file; of a pattern 0 its colour, 1 its normals, 2 its height (r) and roughness (g); null for an image':
    'Índice de la textura en un archivo glTF; de un patrón, 0 su color, 1 sus normales, 2 su altura (r) y rugosidad (g); nulo para una imagen',
  Texture: 'Textura',
  'The channel that drives a number; null takes the colour': 'El canal que da un número; nulo toma el color',
  'sRGB for colours, linear for data': 'sRGB para colores, lineal para datos',
  sRGB: 'sRGB',
  'Color space': 'Espacio de color',
  'How often the image repeats over the surface': 'Cuántas veces se repite la imagen en la superficie',
  Repeat: 'Repetición',
  'Shift in texture coordinates': 'Desplazamiento en coordenadas de textura',
  Offset: 'Desplazamiento',
  'Rotation of the image': 'Rotación de la imagen',
  'What lies beyond the image’s edge': 'Qué hay más allá del borde de la imagen',
  Mirror: 'Espejo',
  Clamp: 'Borde extendido',
  Wrap: 'Fuera del borde',
  'Which set of texture coordinates': 'Qué juego de coordenadas de textura',
  'UV set': 'Juego de UV',
  'Strength of the map': 'Intensidad del mapa',
  'Values of the model’s parameters, by name; what is not here has the model’s default':
    'Valores de los parámetros del modelo, por nombre; lo que no está aquí tiene el valor por omisión del modelo',
  'Colour of the light that the surface emits, linear Rec. 709':
    'Color de la luz que emite la superficie, Rec. 709 lineal',
  Emissive: 'Emisión',
  'Luminance of the emitted light': 'Luminancia de la luz emitida',
  'Emissive intensity': 'Intensidad de emisión',
  'Opaque; mask: there or not; blend: see-through':
    'Opaco; máscara: está o no está; mezcla: deja ver a través',
  Opaque: 'Opaco',
  Mask: 'Máscara',
  'Alpha mode': 'Modo de alfa',
  'With mask: what is less opaque than this is not there':
    'Con máscara: lo que es menos opaco que esto no está',
  'Alpha cutoff': 'Umbral de alfa',
  'With mask or blend: how opaque the surface is': 'Con máscara o mezcla: lo opaca que es la superficie',
  Opacity: 'Opacidad',
  'Show the faces’ backs too': 'Muestra también el reverso de las caras',
  'Double sided': 'Dos caras',
  'Adds the light that bounces from facet to facet: rough metals keep their brightness. For models that know it':
    'Añade la luz que rebota de faceta en faceta: los metales rugosos conservan su brillo. Para los modelos que la conocen',
  'Multiple scattering': 'Dispersión múltiple',
  'Textures of the model’s parameters, by name: value times texel':
    'Texturas de los parámetros del modelo, por nombre: valor por téxel',
  Textures: 'Texturas',
  'Tangent space normal map': 'Mapa de normales en el espacio tangente',
  'Normal map': 'Mapa de normales',
  'Height map that bends the normal': 'Mapa de alturas que inclina la normal',
  'Bump map': 'Mapa de relieve',
  'Ambient occlusion: darkens ambient and environment light':
    'Oclusión ambiental: oscurece la luz ambiental y la del entorno',
  'Occlusion map': 'Mapa de oclusión',
  'Multiplies the emitted light': 'Multiplica la luz emitida',
  'Emissive map': 'Mapa de emisión',
  'With mask or blend: multiplies the opacity, by its alpha unless a channel is chosen':
    'Con máscara o mezcla: multiplica la opacidad, por su alfa salvo que se elija un canal',
  'Opacity map': 'Mapa de opacidad',
  'Whether the object is shown': 'Si el objeto se muestra',
  'Where the object is': 'Dónde está el objeto',
  'Rotation about x, then y, then z, each the object’s own':
    'Rotación en torno a x, luego a y, luego a z, siempre las del propio objeto',
  'Scale along the object’s own axes': 'Escala a lo largo de los ejes del propio objeto',
  'What the surface is made of': 'De qué está hecha la superficie',
  'Vertical field of view': 'Campo de visión vertical',
  'Field of view': 'Campo de visión',
  'Where the camera is': 'Dónde está la cámara',
  'The point that the camera looks at and orbits': 'El punto al que mira la cámara y en torno al cual gira',
  'Nothing closer than this is drawn': 'No se dibuja nada más cercano que esto',
  Near: 'Cerca',
  'Nothing farther than this is drawn': 'No se dibuja nada más lejano que esto',
  Far: 'Lejos',
  'Height of the picture behind the lens; a small one leaves more in focus':
    'Altura de la imagen tras la lente; con una pequeña queda más enfocado',
  'Sensor height': 'Altura del sensor',
  'Focal length over the aperture’s diameter: a small f-number lets in more light and leaves less in focus; 0 is a pinhole, all in focus, exposed as f/16':
    'Distancia focal entre el diámetro de la apertura: un número f pequeño deja pasar más luz y deja menos enfocado; 0 es una cámara estenopeica, todo enfocado, expuesta como f/16',
  'f-number': 'Número f',
  'How long the picture is exposed: the longer, the brighter and the more blurred by motion':
    'Cuánto tiempo se expone la imagen: cuanto más, más clara y más borrosa por el movimiento',
  Shutter: 'Obturador',
  'Sensitivity of film or sensor: the higher, the brighter':
    'Sensibilidad de la película o del sensor: cuanto mayor, más clara',
  ISO: 'ISO',
  'Distance along the view that is in focus; 0 is the target’s':
    'Distancia en la dirección de la vista que está enfocada; 0 es la del objetivo',
  'Focus distance': 'Distancia de enfoque',
  'Corners of what is out of focus; fewer than 3 is round':
    'Esquinas de lo que está desenfocado; con menos de 3 es redondo',
  'Aperture blades': 'Hojas del diafragma',
  'Part of the light that is scattered or absorbed per metre; 0 is clear air':
    'Parte de la luz que se dispersa o se absorbe por metro; 0 es aire limpio',
  Density: 'Densidad',
  'Part of that light which is scattered, not absorbed, linear Rec. 709':
    'Parte de esa luz que se dispersa y no se absorbe, Rec. 709 lineal',
  'Mean cosine of the angle by which light is turned; above 0 it goes on forwards':
    'Coseno medio del ángulo que gira la luz; por encima de 0 sigue hacia delante',
  Anisotropy: 'Anisotropía',
  'Above its base, fog is thinner by a factor e with every step of this height; 0 is as dense everywhere':
    'Por encima de su base, la niebla es más tenue en un factor e por cada tramo de esta altura; con 0 es igual de densa en todas partes',
  'How high fog lies that is thinner above': 'A qué altura está la niebla que arriba es más tenue',
  Base: 'Base',
  'The picture, or what is behind it: luminance in false colours, distance, directions of the surface, texture coordinates, motion, how often a pixel is drawn, how many lamps reach it, which of the sun’s shadow maps it has, how much of its surroundings is open':
    'La imagen, o lo que hay detrás de ella: luminancia en colores falsos, distancia, direcciones de la superficie, coordenadas de textura, movimiento, cuántas veces se dibuja un píxel, cuántas lámparas le llegan, qué mapa de sombras del sol tiene, cuánto de su alrededor está abierto',
  'Shading normals': 'Normales de sombreado',
  'Mesh normals': 'Normales de la malla',
  Tangents: 'Tangentes',
  Motion: 'Movimiento',
  Overdraw: 'Sobredibujado',
  'What exposes the picture: this panel alone, the camera’s f-number, shutter and ISO, or a meter that follows what is seen':
    'Qué expone la imagen: solo este panel, el número f, el obturador y la ISO de la cámara, o un fotómetro que sigue lo que se ve',
  Manual: 'Manual',
  Auto: 'Automático',
  'Exposure mode': 'Modo de exposición',
  'Exposure, beside what camera or meter say: the picture is multiplied by 2 to this power':
    'Exposición, además de lo que digan la cámara o el fotómetro: la imagen se multiplica por 2 elevado a esto',
  Exposure: 'Exposición',
  'How radiance becomes a colour on the screen': 'Cómo se convierte la radiancia en un color de la pantalla',
  ACES: 'ACES',
  AgX: 'AgX',
  Neutral: 'Neutro',
  'Tone mapping': 'Mapeo de tonos',
  'Pixels rendered per pixel of the viewport, along each side':
    'Píxeles que se calculan por cada píxel del visor, a lo largo de cada lado',
  'Resolution scale': 'Escala de resolución',
  'What a frame may take the GPU: while things move, fewer pixels are rendered, half along each side at the least, to hold it; 0 renders all':
    'Lo que puede costarle un fotograma a la GPU: mientras algo se mueve se calculan menos píxeles, como mínimo la mitad por lado, para cumplirlo; 0 los calcula todos',
  'Target frame time': 'Tiempo por fotograma',
  'Show where the lights are and where they shine': 'Muestra dónde están las luces y hacia dónde iluminan',
  Helpers: 'Guías',
  'Paths per pixel after which the picture is complete':
    'Caminos por píxel tras los que la imagen está completa',
  'Relative error at which the picture is complete: standard deviation of a pixel over the mean of all; 0 renders all samples':
    'Error relativo con el que la imagen está completa: desviación típica de un píxel entre la media de todos; 0 calcula todas las muestras',
  Error: 'Error',
  'The most surfaces and scatterings that a path of light meets':
    'El máximo de superficies y dispersiones que encuentra un camino de luz',
  'Max depth': 'Profundidad máxima',
  'The most radiance that a sample of indirect light brings, against bright specks; loses light; 0 does not bound it':
    'La mayor radiancia que aporta una muestra de luz indirecta, contra las motas brillantes; pierde luz; 0 no la limita',
  'Chooses the random numbers': 'Elige los números aleatorios',
  Red: 'Rojo',
  Green: 'Verde',
  Blue: 'Azul',
  Viewer: 'Observador',
  Low: 'Bajo',
  'Plain shading, four samples a pixel: every lamp shines through everything':
    'Sombreado sencillo, cuatro muestras por píxel: cada lámpara lo atraviesa todo',
  Medium: 'Medio',
  'Shadows of all lamps, darker corners, depth of field where the lens has an aperture':
    'Sombras de todas las lámparas, rincones más oscuros, profundidad de campo donde la lente tiene apertura',
  High: 'Alto',
  'Also contact shadows and reflections of what is in the picture; edges smoothed over time':
    'Además, sombras de contacto y reflejos de lo que hay en la imagen; bordes suavizados en el tiempo',
  Ultra: 'Ultra',
  'Also light that bounces between surfaces, and more samples of everything':
    'Además, luz que rebota entre superficies, y más muestras de todo',
  Cube: 'Cubo',
  Mesh: 'Malla',
  'Ambient light': 'Luz ambiental',
  'Hemisphere light': 'Luz hemisférica',
  'Directional light': 'Luz direccional',
  'Point light': 'Luz puntual',
  'Spot light': 'Foco de luz',
  'Rectangle light': 'Luz rectangular',
  'Effects: {name}': 'Efectos: {name}',
  'Too many segments: all shapes together may have at most {maxQuadsInAll} triangles':
    'Demasiados segmentos: todas las formas juntas pueden tener como mucho {maxQuadsInAll} triángulos',
  'Too many segments: a geometry may have at most {maxQuads} triangles':
    'Demasiados segmentos: una geometría puede tener como mucho {maxQuads} triángulos',
  'Too many entries: at most {maxParameters}': 'Demasiadas entradas: como mucho {maxParameters}',
};
