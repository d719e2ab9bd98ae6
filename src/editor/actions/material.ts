/** Materials: the library, comparing and varying. What does it is loaded when the page has its first picture. */
import { endComparison } from '../compare/ending.ts';
import { t } from '../language/language.ts';
import type { MaterialContext, MaterialTools } from '../panels/library/tools.ts';
import { selectedMaterial } from '../selected-material.ts';
import { toastError } from '../ui/toast.ts';
import type { Action } from './action.ts';

let loaded: MaterialTools | null = null;
let loading: Promise<MaterialTools> | null = null;

/** The page's own, the same ones each time. */
export function materialTools(context: MaterialContext): Promise<MaterialTools> {
  loading ??= import('../panels/library/tools.ts').then(({ createMaterialTools }) => {
    loaded = createMaterialTools(context);
    return loaded;
  });
  return loading;
}

/** After the first pictures, when the page has nothing better to do, ms. */
const REST_MS = 1500;

/** Pictures in the outliner, and materials that can be dragged, without anybody's asking. */
export function loadMaterialTools(context: MaterialContext): void {
  const load = () =>
    void materialTools(context).catch(() => {
      loading = null;
    });
  window.setTimeout(() => ('requestIdleCallback' in window ? requestIdleCallback(load) : load()), REST_MS);
}

export function materialActions(context: MaterialContext): Action[] {
  const { store, state } = context.session;
  const chosen = () => selectedMaterial(store.document, state.value.selection);
  const enabled = () => chosen() !== undefined;
  const use = async (run: (tools: MaterialTools) => void) => {
    try {
      run(await materialTools(context));
    } catch (error) {
      // Without a network it may not come; the next try asks again.
      loading = null;
      toastError(t('The library of materials could not be loaded'), error);
    }
  };
  const withChosen = (run: (tools: MaterialTools, id: string) => void) => () =>
    void use((tools) => {
      const id = chosen();
      if (id !== undefined) run(tools, id);
    });
  return [
    {
      id: 'material.endComparison',
      title: t('End the comparison of two materials'),
      keys: ['Escape'],
      enabled: () => state.value.comparison !== null,
      run: () => endComparison(state),
    },
    {
      id: 'material.library',
      title: t('Library of materials'),
      keys: ['M'],
      on: () => loaded?.library.isOpen === true,
      run: () => void use(({ library }) => (library.isOpen ? library.close() : library.open())),
    },
    {
      id: 'material.keep',
      title: t('Put the material into My library'),
      enabled,
      run: withChosen(({ library }, id) => void library.keep(id)),
    },
    {
      id: 'material.compare',
      title: t('Compare the material with…'),
      enabled,
      run: withChosen((tools, id) => tools.compare(id)),
    },
    {
      id: 'material.vary',
      title: t('Vary the material…'),
      enabled,
      run: withChosen((tools, id) => tools.vary(id)),
    },
    {
      id: 'material.randomise',
      title: t('Randomise the material'),
      enabled,
      run: withChosen((tools, id) => tools.randomise(id)),
    },
  ];
}
