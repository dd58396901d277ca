import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";

/** A component whose code is not part of the first download. */
export type Lazy<Props> = ComponentType<Props> & {
  /** Loads the code before the component is shown. */
  preload: () => void;
};

/** Returns a component whose code is loaded when it is first shown, or before by `preload`. */
export function lazy<Props extends object>(load: () => Promise<ComponentType<Props>>): Lazy<Props> {
  const loaded = signal<{ Component: ComponentType<Props> } | "failed" | undefined>(undefined);
  let isLoading = false;
  const preload = () => {
    if (isLoading) return;
    isLoading = true;
    load().then(
      (Component) => {
        loaded.value = { Component };
      },
      () => {
        isLoading = false;
        loaded.value = "failed";
      },
    );
  };
  function LazyComponent(props: Props) {
    const state = loaded.value;
    useEffect(preload, []);
    if (state === undefined) return null;
    if (state !== "failed") return <state.Component {...props} />;
    return (
      <p class="note" role="alert">
        This part of the program could not be loaded. Check the connection to the network.{" "}
        <button type="button" class="button" onClick={preload}>
          Try again
        </button>
      </p>
    );
  }
  return Object.assign(LazyComponent, { preload });
}
