import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import { isBuiltin, resolveBuiltin, resolveKernelBuiltin } from './builtins.ts';
import { convert, fold } from './construct.ts';
import type { Expr, FunctionIR, Variable } from './ir.ts';
import type { Scope } from './scope.ts';
import { checkTarget } from './target.ts';
import { convertsImplicitly, INT, type Type, vector } from './types.ts';

/**
 * A call of the program's own function, or else of a built-in one, by the overload that the arguments
 * choose.
 *
 * @throws BrdfError if there is none, or no single one
 */
export function callFunction(name: string, args: readonly Expr[], place: SourcePlace, scope: Scope): Expr {
  const user = chooseOverload(scope.functions.get(name) ?? [], args, name, place);
  if (user) {
    const converted = user.arguments.map(({ variable, qualifier }, i) => {
      const arg = args[i] as Expr;
      return qualifier === 'in' ? convert(arg, variable.type) : checkTarget(arg);
    });
    return {
      kind: 'call',
      place,
      type: user.result,
      constant: false,
      callee: scope.called(user),
      args: converted,
    };
  }
  if (name === 'fetchData' && scope.table) return fetchData(scope.table, args, place, scope);
  const argTypes = args.map((arg) => arg.type);
  const memory = scope.isKernel ? resolveKernelBuiltin(name, argTypes) : null;
  if (memory) return { kind: 'builtin', place, type: memory.result, constant: false, name, args };
  const builtin = resolveBuiltin(name, argTypes);
  if (builtin) {
    const converted = args.map((arg, i) => convert(arg, builtin.args[i] as Type));
    return fold({
      kind: 'builtin',
      place,
      type: builtin.result,
      constant: args.every((arg) => arg.constant),
      name: name,
      args: converted,
    });
  }
  const types = argTypes.map((type) => type.name).join(', ');
  const known = scope.functions.get(name)?.map(signature) ?? [];
  throw new BrdfError(
    place,
    `there is no function ${name}(${types})`,
    known.length > 0
      ? known.join(' or ')
      : isBuiltin(name)
        ? 'arguments that GLSL defines for it'
        : undefined,
  );
}

/** vec3 fetchData(int i): the i-th triple of the model's measured data. */
function fetchData(table: Variable, args: readonly Expr[], place: SourcePlace, scope: Scope): Expr {
  const [index] = args;
  if (args.length !== 1 || index?.type !== INT) {
    throw new BrdfError(place, `fetchData(${args.map((arg) => arg.type.name).join(', ')})`, 'fetchData(int)');
  }
  scope.used.add(table);
  const data: Expr = { kind: 'variable', place, type: table.type, constant: false, variable: table };
  return {
    kind: 'builtin',
    place,
    type: vector('float', 3),
    constant: false,
    name: 'fetchData',
    args: [data, index],
  };
}

function chooseOverload(
  overloads: readonly FunctionIR[],
  args: readonly Expr[],
  name: string,
  place: SourcePlace,
): FunctionIR | null {
  const ranked = overloads
    .filter(
      (f) =>
        f.arguments.length === args.length &&
        f.arguments.every(({ variable, qualifier }, i) =>
          qualifier === 'in'
            ? convertsImplicitly((args[i] as Expr).type, variable.type)
            : (args[i] as Expr).type === variable.type,
        ),
    )
    .map((f) => ({
      f,
      conversions: f.arguments.filter(({ variable }, i) => (args[i] as Expr).type !== variable.type).length,
    }))
    .sort((a, b) => a.conversions - b.conversions);
  const [best, next] = ranked;
  if (best && next && best.conversions === next.conversions)
    throw new BrdfError(
      place,
      `this call of ${name} fits two overloads`,
      `${signature(best.f)} or ${signature(next.f)} alone`,
    );
  return best?.f ?? null;
}

function signature(f: FunctionIR): string {
  return `${f.name}(${f.arguments.map(({ variable }) => (variable as Variable).type.name).join(', ')})`;
}
