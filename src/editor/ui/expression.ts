/**
 * Reads what is typed into a number field: a number or arithmetic on numbers (`1/3`, `2*(5+1)`,
 * `1e-3`, a decimal comma). A parser of its own because the page's content security policy
 * forbids eval. Null when the text is not a finite number.
 */
export function evaluateExpression(text: string): number | null {
  const tokens = text.replace(/,/g, '.').match(/\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?|[-+*/()]|\S/gi);
  if (!tokens || tokens.length > 64) return null;
  let position = 0;

  const primary = (): number => {
    const token = tokens[position];
    position += 1;
    if (token === '-') return -primary();
    if (token === '+') return primary();
    if (token === '(') {
      const value = sum();
      if (tokens[position] !== ')') return Number.NaN;
      position += 1;
      return value;
    }
    return token !== undefined && /^[\d.]/.test(token) ? Number(token) : Number.NaN;
  };
  const product = (): number => {
    let value = primary();
    while (tokens[position] === '*' || tokens[position] === '/') {
      const operator = tokens[position];
      position += 1;
      const right = primary();
      value = operator === '*' ? value * right : value / right;
    }
    return value;
  };
  const sum = (): number => {
    let value = product();
    while (tokens[position] === '+' || tokens[position] === '-') {
      const operator = tokens[position];
      position += 1;
      const right = product();
      value = operator === '+' ? value + right : value - right;
    }
    return value;
  };

  const value = sum();
  return position === tokens.length && Number.isFinite(value) ? value : null;
}

/** Rounds away binary noise, keeping what a person can mean: `digits` significant digits. */
export function roundTo(value: number, step: number): number {
  if (step <= 0) return value;
  const decimals = Math.max(0, Math.min(12, Math.ceil(-Math.log10(step) - 1e-9)));
  return Number((Math.round(value / step) * step).toFixed(decimals));
}

/** A number as the fields show it: short, never in a form that reads as another value. */
export function formatNumber(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const magnitude = Math.abs(value);
  if (magnitude !== 0 && (magnitude < 1e-4 || magnitude >= 1e7)) {
    return value
      .toExponential(3)
      .replace(/\.?0+e/, 'e')
      .replace('e+', 'e');
  }
  // Within a thousandth of the value.
  const decimals =
    magnitude >= 1000 ? 1 : magnitude >= 10 ? 2 : magnitude >= 1 ? 3 : magnitude >= 0.1 ? 4 : 5;
  return String(Number(value.toFixed(decimals)));
}
