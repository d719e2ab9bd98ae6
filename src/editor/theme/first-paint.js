/**
 * The theme that the person chose, before anything is painted: a plain script that the page waits for, since its policy
 * allows none within it, and modules come after the first paint. theme.ts has the rest.
 */
try {
  document.documentElement.dataset.theme = localStorage.getItem('irradia.theme') ?? 'dark';
} catch {
  // Storage is forbidden here: the page is dark.
}
