/** How many things are done at a time: more would keep the page busy with beginning them. */
const maxConcurrent = 32;

/** Does something with each of some things, a few at a time; what comes of them is in their order. */
export async function mapConcurrent<In, Out>(
  things: readonly In[],
  work: (thing: In) => Promise<Out>,
): Promise<Out[]> {
  const results: Out[] = [];
  const waiting = things.entries();
  const lane = async () => {
    for (const [at, thing] of waiting) results[at] = await work(thing);
  };
  await Promise.all(Array.from({ length: maxConcurrent }, lane));
  return results;
}
