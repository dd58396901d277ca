/** Maximum number of concurrent calls; starting more would block the page. */
const maxConcurrent = 32;

/** Maps items by an async function, several at a time. The results have the order of the items. */
export async function mapConcurrent<In, Out>(
  items: readonly In[],
  map: (item: In) => Promise<Out>,
): Promise<Out[]> {
  const results: Out[] = [];
  const queue = items.entries();
  const runQueue = async () => {
    for (const [index, item] of queue) results[index] = await map(item);
  };
  await Promise.all(Array.from({ length: maxConcurrent }, runQueue));
  return results;
}
