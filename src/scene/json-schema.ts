/** The document's schema for other programs: editors that complete and check scene files, generators. */
import { z } from 'zod';
import { documentFileSchema } from './schema.ts';

/** JSON Schema, draft 2020-12, of what a file may hold. */
export function documentJsonSchema(): Record<string, unknown> {
  const schema = z.toJSONSchema(documentFileSchema, { io: 'input' });
  return {
    ...schema,
    title: 'Irradia document',
    description:
      'A scene. References between its parts, and the parameters of its materials’ models, are checked beyond this schema.',
  };
}

export function documentJsonSchemaText(): string {
  return `${JSON.stringify(documentJsonSchema(), null, 2)}\n`;
}
