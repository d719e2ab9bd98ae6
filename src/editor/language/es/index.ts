/** Spanish. glossary.md beside this file says which word stands for which. */
import type { Catalogue } from '../catalogue.ts';

const catalogue: Catalogue = {};

export default catalogue;
