/** The lessons. They are loaded when somebody wants one. */

import { t } from '../language/language.ts';
import type { Learning } from '../learn/learn.ts';
import type { Session } from '../session.ts';
import { toastError } from '../ui/toast.ts';
import type { Action } from './action.ts';

let loaded: Learning | null = null;
let loading: Promise<Learning> | null = null;

/** The page's lessons, the same ones each time. */
export function learning(session: Session): Promise<Learning> {
  loading ??= import('../learn/learn.ts').then(
    ({ Learning }) => {
      loaded = new Learning(session);
      return loaded;
    },
    (error: unknown) => {
      // Without a network they may not come; the next try asks again.
      loading = null;
      throw error;
    },
  );
  return loading;
}

export function learnActions(session: Session): Action[] {
  const inLesson = () => loaded?.course != null;
  const show = async () => {
    try {
      (await learning(session)).showList();
    } catch (error) {
      toastError(t('The lessons could not be loaded'), error);
    }
  };
  return [
    {
      id: 'learn.lessons',
      title: t('Lessons'),
      on: () => loaded?.isOpen === true,
      run: () => {
        if (loaded?.isOpen) void loaded.leave();
        else void show();
      },
    },
    {
      id: 'learn.next',
      title: t('Next step of the lesson'),
      keys: ['PageDown', ']'],
      enabled: inLesson,
      run: () => {
        if (loaded?.course?.isLast) loaded.showList();
        else loaded?.go((loaded.course?.index ?? 0) + 1);
      },
    },
    {
      id: 'learn.back',
      title: t('Previous step of the lesson'),
      keys: ['PageUp', '['],
      enabled: () => loaded?.course?.isFirst === false,
      run: () => loaded?.go((loaded.course?.index ?? 0) - 1),
    },
    {
      id: 'learn.reset',
      title: t('The lesson’s step as it was'),
      enabled: inLesson,
      run: () => loaded?.reset(),
    },
  ];
}
