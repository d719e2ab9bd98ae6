/** Lessons. */
import type { Catalogue } from '../catalogue.ts';

export const lessons: Catalogue = {
  'Lesson: {step}': 'Lección: {step}',
  'What was open before could not be opened': 'No se ha podido abrir lo que estaba abierto antes',
  'The lesson was not opened; the scene is unchanged':
    'La lección no se ha abierto; la escena no ha cambiado',
  'Lessons, from light to a complete material': 'Lecciones, de la luz a un material completo',
  Learn: 'Aprender',
  'From one lamp to a complete material: a formula, a slider and a picture at every step.':
    'De una lámpara a un material completo: en cada paso, una fórmula, un control y una imagen.',
  'A lesson of your own: drop a folder or a .zip with lesson.en.md and scene.json on the page.':
    'Una lección propia: suelta en la página una carpeta o un .zip con lesson.es.md y scene.json.',
  seen: 'vista',
  begun: 'empezada',
  '{minutes} min': '{minutes} min',
  'All lessons': 'Todas las lecciones',
  'This step as it was': 'Este paso como estaba',
  'Leave the lessons': 'Dejar las lecciones',
  Steps: 'Pasos',
  Back: 'Atrás',
  Next: 'Siguiente',
  '{step} of {count}': '{step} de {count}',
  Do: 'Haz',
  See: 'Mira',
  'As before': 'Como antes',
  'The picture shows it alone.': 'La imagen lo muestra a solas.',
};
