/** Page sizes at which the app is tested. */

export const viewports = {
  desktop: { width: 1440, height: 900 },
  "small window": { width: 1024, height: 600 },
  "200 % zoom": { width: 720, height: 450 },
  "landscape phone": { width: 844, height: 390 },
  phone: { width: 390, height: 844 },
} as const;

export const eachViewport = Object.entries(viewports) as [
  keyof typeof viewports,
  { width: number; height: number },
][];
