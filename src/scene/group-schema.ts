/**
 * Groups: named sets of objects and lights, which may stand in one another. They are for people alone: what is
 * in a group stays in world coordinates, so that no renderer has to know of them.
 */
import { z } from 'zod';
import { boolean, referenceOrNull, text, withDefaults } from './fields.ts';

export const groupShape = {
  name: text('Shown in the outliner', 200),
  parent: referenceOrNull('The group that this one is in', 'groups'),
} as const;

export const groupSchema = z.strictObject(groupShape);
export type Group = z.output<typeof groupSchema>;

const groupDefaults: Readonly<Group> = { name: 'Group', parent: null };

export const groupFileSchema = withDefaults(groupShape, groupDefaults);

/** What objects and lights have in common beside their names. */
export const memberShape = {
  locked: boolean('Whether it is kept from being picked in the picture, moved and deleted'),
  group: referenceOrNull('The group that it is in', 'groups'),
} as const;

export const memberDefaults = { locked: false, group: null } as const;
