/** Page sizes at which the app is tested. */

import { test } from "./app";

export const viewports = {
  desktop: { width: 1440, height: 900 },
  "small window": { width: 1024, height: 600 },
  "200 % zoom": { width: 720, height: 450 },
  "landscape phone": { width: 844, height: 390 },
  phone: { width: 390, height: 844 },
} as const;

export const tablets = {
  tablet: { width: 820, height: 1180 },
  "landscape tablet": { width: 1180, height: 820 },
} as const;

export type PageSize = keyof typeof viewports;

const eachViewport = Object.entries(viewports) as [PageSize, { width: number; height: number }][];

/** Defines tests for pages of every size, or of every size but some. */
export function atEachSize(define: (size: PageSize) => void, except: readonly PageSize[] = []) {
  for (const [size, viewport] of eachViewport) {
    if (except.includes(size)) continue;
    test.describe(size, () => {
      test.use({ viewport });
      define(size);
    });
  }
}

/** Defines tests for phones with touch, upright and in landscape. */
export function onPhones(define: (size: PageSize) => void) {
  for (const size of ["phone", "landscape phone"] as const) {
    test.describe(`${size}, touch`, () => {
      test.use({ viewport: viewports[size], hasTouch: true, isMobile: true });
      define(size);
    });
  }
}

/** Defines tests for tablets with touch, upright and in landscape. */
export function onTablets(define: () => void) {
  for (const [name, viewport] of Object.entries(tablets)) {
    test.describe(name, () => {
      test.use({ viewport, hasTouch: true, isMobile: true });
      define();
    });
  }
}
