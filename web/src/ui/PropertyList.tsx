/** A list of names and values; entries without a value are left out. */
export function PropertyList({
  properties,
}: {
  properties: readonly (readonly [name: string, value: string | false | 0 | undefined])[];
}) {
  return (
    <dl class="property-list">
      {properties.map(
        ([name, value]) =>
          value && (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ),
      )}
    </dl>
  );
}
