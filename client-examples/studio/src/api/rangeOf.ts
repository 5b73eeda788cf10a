import schemas from "./generated/schemas.json";

export interface Range {
  readonly minimum: number;
  readonly maximum: number;
  readonly default: number | null;
  readonly integer: boolean;
  readonly description: string;
}

interface Schema {
  readonly $ref?: string;
  readonly type?: string | readonly string[];
  readonly minimum?: number;
  readonly maximum?: number;
  readonly default?: unknown;
  readonly description?: string;
  readonly allOf?: readonly Schema[];
  readonly oneOf?: readonly Schema[];
  readonly properties?: Readonly<Record<string, Schema>>;
}

const kSchemas: Readonly<Record<string, Schema>> = schemas as Readonly<Record<string, Schema>>;

/** Follows references; what stands beside one wins over what it points to. */
function resolve(schema: Schema): Schema {
  const { $ref, allOf = [], oneOf = [], ...own } = schema;
  const parts = [...($ref ? [kSchemas[$ref.replace("#/components/schemas/", "")] ?? {}] : []), ...allOf, ...oneOf.filter((s) => s.minimum !== undefined || s.$ref)];
  return parts.map(resolve).reduceRight<Schema>((result, part) => ({ ...part, ...result }), own);
}

/**
 * What the contract allows for a number.
 * @param schema  a schema of the contract, such as "Tuft"
 * @param property  one of its properties; without it, the schema itself
 * @throws if the contract gives it no range: then this page and the contract have grown apart
 */
export function rangeOf(schema: string, property?: string): Range {
  const whole = kSchemas[schema];
  const part = property === undefined ? whole : whole && resolve(whole).properties?.[property];
  const { minimum, maximum, type = "number", description = "", ...rest } = resolve(part ?? {});
  if (minimum === undefined || maximum === undefined) throw new Error(`the contract gives no range for ${schema} ${property ?? ""}`);
  return { minimum, maximum, default: typeof rest.default === "number" ? rest.default : null, integer: type === "integer" || type[0] === "integer", description };
}
