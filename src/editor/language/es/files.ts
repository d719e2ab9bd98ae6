/** Faults in files of models, images and measurements, and what an import could not keep. */
import type { Catalogue } from '../catalogue.ts';

export const files: Catalogue = {
  'not saved parameters': 'no son parámetros guardados',
  "'bparam FILE.brdf'": "'bparam ARCHIVO.brdf'",
  'the file ends here; expected {more} more bytes of samples':
    'el archivo termina aquí; se esperaban {more} bytes más de muestras',
  '{more} bytes after the last sample; expected the end of the file':
    '{more} bytes después de la última muestra; se esperaba el final del archivo',
  'points to byte {offset}, outside the file': 'señala el byte {offset}, fuera del archivo',
  'the file ends here; expected {size} more bytes': 'el archivo termina aquí; se esperaban {size} bytes más',
  'a name that does not end': 'un nombre que no termina',
  'not a CSAIL BRDF: {count} bins of {axis}; expected 1 to {LONGEST_AXIS}':
    'no es una BRDF de CSAIL: {count} celdas de {axis}; se esperaban de 1 a {LONGEST_AXIS}',
  '{what} is {value}; expected {list}': '{what} es {value}; se esperaba {list}',
  '{list} bins; expected {MOST_SAMPLES} in all, or even numbers of phi_diff and phi_in to halve':
    '{list} celdas; se esperaban {MOST_SAMPLES} en total, o números pares de phi_diff y phi_in para reducirlos a la mitad',
  'every sample is negative: the file has no data':
    'todas las muestras son negativas: el archivo no tiene datos',
  'the sample is {value}; expected a finite reflection':
    'la muestra es {value}; se esperaba una reflexión finita',
  'half_data is {half}; expected 0 or 1': 'half_data es {half}; se esperaba 0 o 1',
  'the file is too short for {width} x {height} pixels':
    'el archivo es demasiado corto para {width} x {height} píxeles',
  'a chunk starts at line {top}, which no chunk or another one does':
    'un bloque empieza en la línea {top}, en la que no empieza ninguno o empieza otro',
  'not an OpenEXR file': 'no es un archivo OpenEXR',
  'version {version} of the format; expected 2': 'versión {version} del formato; se esperaba la 2',
  'a file of {what}; expected one part of scan lines':
    'un archivo de {what}; se esperaba una sola parte de líneas',
  'the header has no {name}': 'la cabecera no tiene {name}',
  'compression {compression} is not supported; expected none, ZIPS or ZIP':
    'la compresión {compression} no se admite; se esperaba ninguna, ZIPS o ZIP',
  'the dataWindow is empty': 'el dataWindow está vacío',
  'channel {name} has pixel type {number}; expected half or float':
    'el canal {name} tiene píxeles de tipo {number}; se esperaba half o float',
  'channel {name} is subsampled': 'el canal {name} está submuestreado',
  'a chunk of {size} bytes; expected at most {expected}':
    'un bloque de {size} bytes; se esperaban como mucho {expected}',
  'a chunk of {size} bytes; expected {expected}': 'un bloque de {size} bytes; se esperaban {expected}',
  'a chunk that is no zlib stream': 'un bloque que no es un flujo zlib',
  'a chunk unpacks to {length} bytes; expected {expected}':
    'un bloque se descomprime en {length} bytes; se esperaban {expected}',
  meshes: 'meshes',
  nodes: 'nodes',
  'the environment is not in a glTF file: whoever shows it chooses one':
    'el entorno no está en un archivo glTF: lo elige quien lo muestra',
  'fog has no counterpart in glTF': 'la niebla no tiene equivalente en glTF',
  cameras: 'cameras',
  'the point that the camera turns about is not in a glTF file':
    'el punto en torno al que gira la cámara no está en un archivo glTF',
  '{name}: in glTF light fades with the square of the distance':
    '{name}: en glTF la luz se atenúa con el cuadrado de la distancia',
  '{name}: in glTF a beam is as bright at its edge as in the middle':
    '{name}: en glTF un haz es tan brillante en el borde como en el centro',
  '{name}: glTF has no lights of the kind {type}': '{name}: glTF no tiene luces de tipo {type}',
  "{name}: the width of its sheen is glTF's own":
    '{name}: la anchura de su brillo aterciopelado es la propia de glTF',
  '{name}: glTF has no bump maps; bake it into a normal map':
    '{name}: glTF no tiene mapas de relieve; conviértelo en un mapa de normales',
  materials: 'materials',
  '{name}: {what} has no counterpart in glTF': '{name}: {what} no tiene equivalente en glTF',
  '{name}: principled-thesis is written as principled, which it is nearly':
    '{name}: principled-thesis se escribe como principled, que es casi lo mismo',
  "{name}: cook-torrance is written as glTF's material, whose distribution of facets is another":
    '{name}: cook-torrance se escribe como el material de glTF, cuya distribución de facetas es otra',
  '{name}: glTF cannot describe the model {model}; it is written in its colour alone. Fit principled to it before, to keep its look':
    '{name}: glTF no puede describir el modelo {model}; se escribe solo con su color. Ajústale antes principled para conservar su aspecto',
  '{name}: its colour texture is linear, which glTF takes for sRGB':
    '{name}: su textura de color es lineal, y glTF la toma por sRGB',
  '{what}: its textures lie differently on the surface, which glTF cannot say; they are left out':
    '{what}: sus texturas están colocadas de otro modo en la superficie, y glTF no puede decirlo; se omiten',
  samplers: 'samplers',
  textures: 'textures',
  'a texture is both rotated and scaled unevenly, which is approximated':
    'una textura está a la vez girada y escalada de forma desigual, lo que se aproxima',
  'its lights are in candela and lux: if the picture is too bright or too dark, change the exposure':
    'sus luces están en candelas y lux: si la imagen es demasiado clara u oscura, cambia la exposición',
  'the file has no surfaces and no lights': 'el archivo no tiene superficies ni luces',
  "{length} bytes are more than the {maxAssetBytes} that a scene's file may have":
    '{length} bytes son más que los {maxAssetBytes} que puede tener el archivo de una escena',
  "it has the variants {names}: objects have the file's first materials, the others are among the scene's materials":
    'tiene las variantes {names}: los objetos tienen los primeros materiales del archivo, los demás están entre los materiales de la escena',
  'there is no {list}[{index}]': 'no hay {list}[{index}]',
  'bytes {offset} to {length} lie beyond the {size} bytes there are':
    'los bytes de {offset} a {length} están más allá de los {size} bytes que hay',
  'cannot hold {count} elements': 'no caben {count} elementos',
  'KHR_draco_mesh_compression is not valid': 'KHR_draco_mesh_compression no es válido',
  'the file describes more data than can be loaded':
    'el archivo describe más datos de los que se pueden cargar',
  'nodes[{i}].children': 'nodes[{i}].children',
  'node {child} already has a parent': 'el nodo {child} ya tiene padre',
  'nodes[{start}]': 'nodes[{start}]',
  'the node is among its own descendants': 'el nodo está entre sus propios descendientes',
  'buffers[{i}]: there is no data for it': 'buffers[{i}]: no hay datos para él',
  'buffers[{i}]: {claimed} bytes announced, {length} are there':
    'buffers[{i}]: se anuncian {claimed} bytes, hay {length}',
  'there is no textures[{texture}]': 'no hay textures[{texture}]',
  'textures[{texture}]: its image is in a format that is not read here':
    'textures[{texture}]: su imagen está en un formato que aquí no se lee',
  'textures[{texture}]: there is no data for it': 'textures[{texture}]: no hay datos para ella',
  'not a glTF file: neither GLB nor JSON': 'no es un archivo glTF: ni GLB ni JSON',
  'not a valid glTF 2.0 file: {path}: {message}': 'no es un archivo glTF 2.0 válido: {path}: {message}',
  'glTF version {version}; only 2.x can be read': 'versión {version} de glTF; solo se puede leer la 2.x',
  '{path}: refers to {uri}, which is not fetched': '{path}: se refiere a {uri}, que no se descarga',
  '{path}: needs the file {uri}; open or drop it together with this one, as a folder or a zip':
    '{path}: necesita el archivo {uri}; ábrelo o suéltalo junto con este, en una carpeta o un zip',
  'nodes[{node}] has no mesh primitive {primitive}':
    'nodes[{node}] no tiene una primitiva de malla {primitive}',
  'nodes[{node}]: primitive {primitive} has no triangles':
    'nodes[{node}]: la primitiva {primitive} no tiene triángulos',
  'the file ends within the GLB header': 'el archivo termina dentro de la cabecera GLB',
  'GLB version {version}; only version 2 can be read': 'versión {version} de GLB; solo se puede leer la 2',
  'truncated: the header says {length} bytes, the file has {length2}':
    'truncado: la cabecera dice {length} bytes, el archivo tiene {length2}',
  'the chunk at byte {at} reaches beyond the file': 'el bloque en el byte {at} sobrepasa el archivo',
  'the GLB has no JSON chunk': 'el GLB no tiene un bloque JSON',
  '{name}: its specular-glossiness map has no counterpart; it is taken for a dielectric':
    '{name}: su mapa de especular y brillo no tiene equivalente; se toma por un dieléctrico',
  'textures[{index}] is in a format that is not read (PNG, JPEG, WebP, AVIF and KTX2 are)':
    'textures[{index}] está en un formato que no se lee (PNG, JPEG, WebP, AVIF y KTX2 sí)',
  'textures[{index}] wraps differently along its sides; both wrap as along the first':
    'textures[{index}] se repite de forma distinta a cada lado; ambos se repiten como el primero',
  'textures[{index}] is both rotated and scaled unevenly, which is approximated':
    'textures[{index}] está a la vez girada y escalada de forma desigual, lo que se aproxima',
  '{index}: its instances are compressed; only one of them is shown':
    '{index}: sus instancias están comprimidas; solo se muestra una de ellas',
  '{path}: accessors[{at}] is not a {type}': '{path}: accessors[{at}] no es un {type}',
  '{path}: {count} instances; at most {MOST_INSTANCES}':
    '{path}: {count} instancias; como mucho {MOST_INSTANCES}',
  '{path}: its attributes are not equally many': '{path}: sus atributos no son igual de numerosos',
  '{path}: its places are not made of finite numbers':
    '{path}: sus lugares no están hechos de números finitos',
  'nodes[{index}]: more than {MOST_INSTANCES} objects': 'nodes[{index}]: más de {MOST_INSTANCES} objetos',
  'textures[{index}] is shown smooth from near, not in squares':
    'textures[{index}] se muestra suave de cerca, no en cuadrados',
  'its animations are not played': 'sus animaciones no se reproducen',
  'it has {length} scenes; only the one that it names is shown':
    'tiene {length} escenas; solo se muestra la que él mismo nombra',
  "it has {cameras} cameras; the view is the first one's":
    'tiene {cameras} cámaras; la vista es la de la primera',
  'it needs the extension {extension}, which is not read': 'necesita la extensión {extension}, que no se lee',
  "{name}: the texture of the clearcoat's roughness has no counterpart":
    '{name}: la textura de la rugosidad del barniz no tiene equivalente',
  "{name}: the texture of the reflection's colour has no counterpart":
    '{name}: la textura del color de la reflexión no tiene equivalente',
  '{name}: the texture of its thickness is not needed: the body is as thick as it is':
    '{name}: la textura de su grosor no hace falta: el cuerpo tiene el grosor que tiene',
  '{name}: the colour texture of the light that its sheet lets through has no counterpart':
    '{name}: la textura de color de la luz que su lámina deja pasar no tiene equivalente',
  '{name}: {extension} is not read': '{name}: {extension} no se lee',
  '{name}: its {field} is not read': '{name}: su {field} no se lee',
  '{name}: its skeleton is not read; it is shown in its bind pose':
    '{name}: su esqueleto no se lee; se muestra en su pose inicial',
  '{name}: points and lines have no surface and are left out':
    '{name}: los puntos y las líneas no tienen superficie y se omiten',
  '{name}: its morph targets are not read': '{name}: sus deformaciones (morph targets) no se leen',
  '{name}: its vertex colours are not read': '{name}: sus colores por vértice no se leen',
  '{name}: it is sheared, which is approximated': '{name}: está sesgado, lo que se aproxima',
  'its camera is orthographic and is left out': 'su cámara es ortográfica y se omite',
  'its background, environment and fog are not read: the scene has its own':
    'su fondo, su entorno y su niebla no se leen: la escena tiene los suyos',
  'its groups are {last} deep: those deeper than {depth} are not kept, what is in them is':
    'sus grupos tienen {last} niveles: los que pasan de {depth} no se conservan, lo que hay en ellos sí',
  accessors: 'accessors',
  images: 'images',
  bufferViews: 'bufferViews',
  'not a kind of model that is read: {list}': 'no es una clase de modelo que se lea: {list}',
  'not a KTX 2.0 image': 'no es una imagen KTX 2.0',
  "its texels have Vulkan's format {vkFormat}; Basis Universal is read":
    'sus téxeles tienen el formato {vkFormat} de Vulkan; se lee Basis Universal',
  'an image of {width} x {height} x {depth} texels': 'una imagen de {width} x {height} x {depth} téxeles',
  'is missing': 'falta',
  '{name}: the colour of the specular reflection has no counterpart':
    '{name}: el color de la reflexión especular no tiene equivalente',
  '{name}: iridescence has no counterpart': '{name}: la iridiscencia no tiene equivalente',
  '{name}: dispersion has no counterpart': '{name}: la dispersión no tiene equivalente',
  "{name}: the clearcoat is rougher than principled's can be":
    '{name}: el barniz es más rugoso de lo que puede ser el de principled',
  "{name}: the clearcoat's own normal map has no counterpart":
    '{name}: el mapa de normales propio del barniz no tiene equivalente',
  "{name}: the sheen's roughness and its own colour have no counterpart":
    '{name}: la rugosidad y el color propio del brillo aterciopelado no tienen equivalente',
  '{name}: the strength of its reflection became its index of refraction':
    '{name}: la intensidad de su reflejo se convirtió en su índice de refracción',
  '{name}: light that its sheet lets through diffusely has the base colour':
    '{name}: la luz que su lámina deja pasar de forma difusa tiene el color base',
  '{name}: light goes through it in the path traced picture; the interactive one shows its reflection':
    '{name}: la luz lo atraviesa en la imagen por trazado de caminos; la interactiva muestra su reflejo',
  '{name}: the rotation of the anisotropy has no counterpart':
    '{name}: la rotación de la anisotropía no tiene equivalente',
  "{name}: the anisotropy's texture has no counterpart":
    '{name}: la textura de la anisotropía no tiene equivalente',
  '{name}: it is unlit, so its colour is light that it emits':
    '{name}: no recibe luz, así que su color es luz que emite',
  'not a MERL BRDF: it has {list} bins; expected {list2}':
    'no es una BRDF de MERL: tiene {list} celdas; se esperaban {list2}',
  'the {c} sample {i} is {stored}; expected a finite reflection':
    'la muestra {i} de {c} es {stored}; se esperaba una reflexión finita',
  'its vertex colours are not read': 'sus colores por vértice no se leen',
  'Loading the environment {name}': 'Cargando el entorno {name}',
  'the environment "{name}" did not come; without a network only what was loaded before is there':
    'el entorno «{name}» no se ha cargado; sin red solo está lo que se cargó antes',
  'its materials in {library} did not come along: drop both files, the folder, or a zip of it':
    'sus materiales de {library} no han venido: suelta los dos archivos, la carpeta o un zip de ella',
  'there is no material {name} in its .mtl file': 'no hay ningún material {name} en su archivo .mtl',
  '"{word}" before the first newmtl': '"{word}" antes del primer newmtl',
  '{name}: {key} is given as {words}, which is not read':
    '{name}: {key} está dado como {words}, que no se lee',
  'expected {count} numbers after "{key}"': 'se esperaban {count} números después de "{key}"',
  '{name}: {what} is not read': '{name}: {what} no se lee',
  'the file has no faces': 'el archivo no tiene caras',
  'its points, lines and curves have no surface and are left out':
    'sus puntos, líneas y curvas no tienen superficie y se omiten',
  '"{word}" is not a word of OBJ': '"{word}" no es una palabra de OBJ',
  'a face needs three corners': 'una cara necesita tres esquinas',
  'a face with more than {MOST_CORNERS} corners': 'una cara con más de {MOST_CORNERS} esquinas',
  'a corner without a vertex': 'una esquina sin vértice',
  '"{word}" is not the number of a {what}': '"{word}" no es el número de un {what}',
  'there is no {what} {number} before this line': 'no hay ningún {what} {number} antes de esta línea',
  'the file has no faces: points alone have no surface to reflect light':
    'el archivo no tiene caras: los puntos solos no tienen superficie que refleje la luz',
  'there is no vertex {beyond}; there are {count}': 'no hay ningún vértice {beyond}; hay {count}',
  'not a PLY file: no header from "ply" to "end_header"':
    'no es un archivo PLY: no hay cabecera de "ply" a "end_header"',
  '"{word}" is not a type of PLY': '"{word}" no es un tipo de PLY',
  'expected "element NAME COUNT"': 'se esperaba "element NAME COUNT"',
  'a property before the first element': 'una propiedad antes del primer elemento',
  '"{words}" is not a word of a PLY header': '"{words}" no es una palabra de la cabecera de PLY',
  'format {format} is not one of PLY': 'el formato {format} no es uno de PLY',
  'the header says {count} of "{name}", {least} bytes each; {left} bytes are left':
    'la cabecera dice {count} de "{name}", de {least} bytes cada uno; quedan {left} bytes',
  'the file ends here, within an element': 'el archivo termina aquí, dentro de un elemento',
  'the header says {count} of "{name}", for which the file is too short':
    'la cabecera dice {count} de "{name}", y el archivo es demasiado corto para ello',
  '"{word}" is not a number': '"{word}" no es un número',
  'no element "vertex" with x, y and z': 'no hay un elemento "vertex" con x, y y z',
  '{name} is not a finite number': '{name} no es un número finito',
  '{index} is not the number of a vertex': '{index} no es el número de un vértice',
  'a list of {size} values; at most {MOST_CORNERS}': 'una lista de {size} valores; como mucho {MOST_CORNERS}',
  'the file has no triangles': 'el archivo no tiene triángulos',
  'a coordinate that is not a finite number': 'una coordenada que no es un número finito',
  'expected three numbers after "vertex"': 'se esperaban tres números después de "vertex"',
  'a facet with {corners} corners; expected 3': 'una faceta con {corners} esquinas; se esperaban 3',
  '"{word}" is not a word of STL': '"{word}" no es una palabra de STL',
  'the file ends within a facet': 'el archivo termina dentro de una faceta',
  'the image {name} is in a format that is not read (PNG, JPEG, WebP, AVIF, KTX2 and TGA are)':
    'la imagen {name} está en un formato que no se lee (sí PNG, JPEG, WebP, AVIF, KTX2 y TGA)',
  'Export a picture…': 'Exportar una imagen…',
  'Export the scene as GLB': 'Exportar la escena como GLB',
  'Export the material as JSON': 'Exportar el material como JSON',
  'Copy the material as code': 'Copiar el material como código',
  '{address} is not an address': '{address} no es una dirección',
  'the image {name} did not come along: drop the whole folder, or a zip of it, to have it':
    'la imagen {name} no ha venido: suelta la carpeta entera, o un zip de ella, para tenerla',
  'there is no {type} in three.js': 'no hay ningún {type} en three.js',
  '{type} cannot be made: {cause}': '{type} no se puede hacer: {cause}',
  'it has no positions': 'no tiene posiciones',
  'it has positions that are not finite numbers': 'tiene posiciones que no son números finitos',
  'its index names vertices that are not there': 'su índice nombra vértices que no existen',
  '{name} is not between 0 and 4096': '{name} no está entre 0 y 4096',
  'it has too many segments': 'tiene demasiados segmentos',
  'an attribute does not say how many values a vertex has':
    'un atributo no dice cuántos valores tiene un vértice',
  '{name}: {type} has a shader of its own, which is not read; its colour is':
    '{name}: {type} tiene un shader propio, que no se lee; su color sí',
  '{name}: it is shown solid, not as a wireframe': '{name}: se muestra sólido, no como alambre',
  'its lines, points and sprites have no surface and are left out':
    'sus líneas, puntos y sprites no tienen superficie y se omiten',
  'a camera of type {type} is left out': 'se omite una cámara de tipo {type}',
  'there is no geometry {geometry}': 'no hay ninguna geometría {geometry}',
  'more than {MOST_OBJECTS} objects': 'más de {MOST_OBJECTS} objetos',
  'a format of three.js before 2015, which three.js itself no longer reads; open and save it with an old version':
    'un formato de three.js anterior a 2015, que el propio three.js ya no lee; ábrelo y guárdalo con una versión antigua',
  'not a scene of three.js: {message}': 'no es una escena de three.js: {message}',
  'its place is not made of finite numbers': 'su lugar no está hecho de números finitos',
  '{called}: a BatchedMesh is shown as one mesh where it lies':
    '{called}: un BatchedMesh se muestra como una sola malla donde está',
  '{called}: the colours of its instances are not read': '{called}: los colores de sus instancias no se leen',
  'its scripts ({count}) are left out: nothing in a file is run':
    'sus scripts ({count}) se omiten: nada de un archivo se ejecuta',
  "the project's environment, shadows and tone mapping are not read":
    'el entorno, las sombras y el mapeo de tonos del proyecto no se leen',
  'Files that Irradia opens': 'Archivos que Irradia abre',
  'a file of deep data, which is not read': 'un archivo de datos profundos (deep), que no se lee',
  'chunk {i} is at byte {at}, outside the file': 'el bloque {i} está en el byte {at}, fuera del archivo',
  'tiles of {width} x {rows} texels': 'teselas de {width} x {rows} téxeles',
  'compression {index}; expected one of {list}': 'compresión {index}; se esperaba una de {list}',
  'an image of {width} x {height} texels; expected 1 to {MOST_TEXELS} in all':
    'una imagen de {width} x {height} téxeles; se esperaban de 1 a {MOST_TEXELS} en total',
  'more than {MOST_CHANNELS} channels': 'más de {MOST_CHANNELS} canales',
  'a list of channels that does not end': 'una lista de canales que no termina',
  'an image of {width} x {height} texels, for which the file is too short or memory is':
    'una imagen de {width} x {height} téxeles, para la que no bastan el archivo o la memoria',
  'not a Radiance HDR image': 'no es una imagen HDR de Radiance',
  'the header does not end with an empty line': 'la cabecera no termina con una línea vacía',
  'its texels are in {format}; expected 32-bit_rle_rgbe':
    'sus téxeles están en {format}; se esperaba 32-bit_rle_rgbe',
  'a size of "{line}"; expected "-Y height +X width", rows from the top':
    'un tamaño de "{line}"; se esperaba "-Y alto +X ancho", con las filas desde arriba',
  'an image without texels': 'una imagen sin téxeles',
  'a row of another width than the image': 'una fila de otro ancho que la imagen',
  'the file ends within a row': 'el archivo termina dentro de una fila',
  'a run of {count} that the row has no room for': 'una serie de {count} que no cabe en la fila',
  'a run of runs': 'una serie de series',
  '{name}: {length} bytes for a {type}; expected {size}':
    '{name}: {length} bytes para un {type}; se esperaban {size}',
  'a texture is not in the file': 'una textura no está en el archivo',
  'a texture wraps differently along its sides; both wrap as along the first':
    'una textura se repite de forma distinta a cada lado; ambos se repiten como el primero',
  'the image {url} is on another server, and not fetched':
    'la imagen {url} está en otro servidor, y no se descarga',
  'a texture of numbers that are not 8-bit RGBA, or of several images, is not read':
    'una textura de números que no son RGBA de 8 bits, o de varias imágenes, no se lee',
  'not a PNG': 'no es un PNG',
  'the file ends here; expected a chunk': 'el archivo termina aquí; se esperaba un bloque',
  'the file ends within a chunk': 'el archivo termina dentro de un bloque',
  'the checksum of chunk {type} is wrong': 'la suma de comprobación del bloque {type} es errónea',
  phi_i: 'phi_i',
  'from {phi} to {at}; expected a turn, a half or a quarter of one':
    'de {phi} a {at}; se esperaba una vuelta, media o un cuarto',
  jacobian: 'jacobian',
  '{length} values; expected 1': '{length} valores; se esperaba 1',
  '{size} values in all; expected {MOST_TRIPLES} at most, what fits on a GPU':
    '{size} valores en total; se esperaban {MOST_TRIPLES} como mucho, lo que cabe en una GPU',
  vndf: 'vndf',
  'nothing but 0 for {which}; expected a density': 'nada más que 0 para {which}; se esperaba una densidad',
  '{length} angles; expected 1 to {LONGEST_AXIS}': '{length} ángulos; se esperaban de 1 a {LONGEST_AXIS}',
  'angle {i} is {value} after {i2}; expected ascending angles':
    'el ángulo {i} es {value} después de {i2}; se esperaban ángulos crecientes',
  'angle {i} is {value}; expected radians up to {largest}':
    'el ángulo {i} es {value}; se esperaban radianes hasta {largest}',
  '{height} x {width} values; expected 2 to {LONGEST_AXIS} along each side':
    '{height} x {width} valores; se esperaban de 2 a {LONGEST_AXIS} por lado',
  '{list} values; expected {list2} x ..., as many as phi_i and theta_i':
    '{list} valores; se esperaban {list2} x ..., tantos como phi_i y theta_i',
  '{list} values; expected {list2}': '{list} valores; se esperaban {list2}',
  wavelengths: 'wavelengths',
  '{length} of them; expected 1 to {MOST_WAVELENGTHS}': '{length}; se esperaban de 1 a {MOST_WAVELENGTHS}',
  '{wrong} after {wrong2}; expected ascending nm': '{wrong} después de {wrong2}; se esperaban nm crecientes',
  'not a tensor file; expected it to begin with "tensor_file"':
    'no es un archivo de tensores; se esperaba que empezara por "tensor_file"',
  'version {list}; expected {list2}': 'versión {list}; se esperaba {list2}',
  '{count} fields; expected {MOST_FIELDS} at most': '{count} campos; se esperaban {MOST_FIELDS} como mucho',
  '{dimensions} dimensions; expected {MOST_DIMENSIONS} at most':
    '{dimensions} dimensiones; se esperaban {MOST_DIMENSIONS} como mucho',
  'no type has the number {type}; expected 1 to 11':
    'ningún tipo tiene el número {type}; se esperaba de 1 a 11',
  '{list} values of {size} bytes from byte {offset} on; the file ends at {length}':
    '{list} valores de {size} bytes desde el byte {offset}; el archivo termina en {length}',
  'the name comes twice': 'el nombre aparece dos veces',
  'field {name}: {message}': 'campo {name}: {message}',
  'there is no field "{name}"; the file has {names}':
    'no hay ningún campo "{name}"; el archivo tiene {names}',
  'type {type}; expected {type2} ({name})': 'tipo {type}; se esperaba {type2} ({name})',
  '{length} dimensions; expected {rank}': '{length} dimensiones; se esperaban {rank}',
  'value {i} is {value}; expected {expected}': 'el valor {i} es {value}; se esperaba {expected}',
  'more than {MOST_FILES} files': 'más de {MOST_FILES} archivos',
  'its files take more than {MOST_BYTES} bytes': 'sus archivos ocupan más de {MOST_BYTES} bytes',
  'not a zip archive that can be read: {cause}': 'no es un archivo zip que se pueda leer: {cause}',
  'there are no files in it': 'no contiene ningún archivo',
  'its thread ended': 'su hilo ha terminado',
  'This browser makes no JPEG of {width} x {height} pixels; PNG works.':
    'Este navegador no hace JPEG de {width} x {height} píxeles; PNG funciona.',
  'it could not be fetched: no connection, or the server does not let other pages have it (CORS)':
    'no se ha podido descargar: no hay conexión, o el servidor no deja que lo tengan otras páginas (CORS)',
  'the server answered {status}': 'el servidor ha respondido {status}',
  'more than {bytes} bytes': 'más de {bytes} bytes',
  'with what lies beside it, more than {bytes} bytes': 'con lo que tiene al lado, más de {bytes} bytes',
  'the image cannot be read: {message}': 'no se puede leer la imagen: {message}',
  'neither a Radiance HDR nor an OpenEXR image': 'no es una imagen Radiance HDR ni OpenEXR',
  'the map of its specular colour': 'el mapa de su color especular',
  'the map of its shininess': 'el mapa de su brillo',
  'its reflection map': 'su mapa de reflexión',
  'its displacement': 'su desplazamiento',
  'the tint of its reflection': 'el tinte de su reflejo',
  'scattering inside': 'la dispersión interna',
};
