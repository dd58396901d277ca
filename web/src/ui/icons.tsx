const paths = {
  play: (
    <path
      d="M5 3.2v9.600c0 .5.500.8.900.5l7.200-4.800a.6.6 0 0 0 0-1L5.900 2.700a.6.6 0 0 0-.9.5z"
      fill="currentColor"
    />
  ),
  pause: <path d="M4.500 3h2.200v10H4.500zM9.300 3h2.200v10H9.300z" fill="currentColor" />,
  loop: (
    <path d="M11 2.500 13 4.500l-2 2M13 4.500H5.500a3 3 0 0 0-3 3v.5M5 13.500l-2-2 2-2M3 11.500h7.500a3 3 0 0 0 3-3V8" />
  ),
  expand: <path d="m4.500 6.500 3.500 3.500 3.500-3.500" />,
  collapse: <path d="m4.500 9.500 3.500-3.500 3.500 3.500" />,
  periodic: (
    <path d="M10.300 5.200a3.600 3.600 0 1 0 1.200 3.600M11.800 3.200l-.1 2.900-2.900-.1" />
  ),
  aperiodic: <path d="M3.500 8h9M9.500 5l3 3-3 3" />,
  "frame-back": <path d="M10.500 3.500 6 8l4.500 4.500M4 3.500v9" />,
  "frame-ahead": <path d="M5.500 3.500 10 8l-4.500 4.500M12 3.500v9" />,
  undo: <path d="M6 3 3 6l3 3M3.500 6H9a3.500 3.500 0 0 1 0 7H6" />,
  redo: <path d="m10 3 3 3-3 3M12.500 6H7a3.500 3.500 0 0 0 0 7h3" />,
  warning: <path d="M8 2.200 14.500 13.500h-13zM8 6.500v3.500M8 11.700v.1" />,
  open: <path d="M2.500 12.500v-9h4l1.500 2h5.500v7zM2.500 7.500h11" />,
  panel: <path d="M2.500 3h11v10h-11zM10 3v10" />,
  sound: (
    <path d="M2.500 6v4h2.500l3.500 3v-10l-3.500 3zM11 5.800a3 3 0 0 1 0 4.400M12.800 4a5.600 5.600 0 0 1 0 8" />
  ),
  muted: (
    <path d="M2.500 6v4h2.500l3.500 3v-10l-3.500 3zM11 6.200l3.500 3.600M14.500 6.200l-3.500 3.600" />
  ),
  delete: (
    <path d="M3 4.500h10M6.500 4.500v-2h3v2M4.500 4.500l.6 9h5.800l.6-9M7 7.500v3M9 7.500v3" />
  ),
  close: <path d="m4 4 8 8M12 4l-8 8" />,
  light: (
    <path d="M8 5.200a2.800 2.800 0 1 0 0 5.600 2.800 2.800 0 0 0 0-5.600zM8 1.500v1.300M8 13.200v1.300M1.500 8h1.300M13.200 8h1.300M3.400 3.400l.9.9M11.700 11.700l.9.9M12.600 3.400l-.9.9M4.300 11.700l-.9.9" />
  ),
  dark: <path d="M13.200 9.800A5.700 5.700 0 0 1 6.200 2.800a5.700 5.700 0 1 0 7 7z" />,
  system: <path d="M2.500 3.500h11v7.500h-11zM6 13.500h4M8 11v2.500" />,
} as const;

export type IconName = keyof typeof paths;

/** A decorative icon of 16 pixels. */
export function Icon({ name }: { name: IconName }) {
  return (
    <svg
      class="icon"
      viewBox="0 0 16 16"
      width="16"
      height="16"
      fill="none"
      stroke={name === "play" || name === "pause" ? "none" : "currentColor"}
      stroke-width="1.4"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden="true"
    >
      {paths[name]}
    </svg>
  );
}

/** The logo of the app: the footprint that the viewer draws on the floor. */
export function Logo() {
  return (
    <svg
      class="logo"
      viewBox="6 0 20 32"
      width="14"
      height="22"
      fill="currentColor"
      aria-hidden="true"
    >
      <path d="M13.600 30c-3 0-4.900-2.100-4.600-5 .3-2.600 1.500-4.300 1.100-7.100C9.700 15 7.600 13.600 8 10.500 8.400 7.600 11.200 6 15.400 6.500c4.600.6 7.600 3.300 7.200 7.400-.4 4-3.600 5.300-4.200 8.700-.7 3.900-1.300 7.400-4.800 7.400z" />
      <circle cx="10.200" cy="3.700" r="2.500" />
      <circle cx="15.100" cy="3.300" r="1.800" />
      <circle cx="18.900" cy="4.400" r="1.600" />
      <circle cx="22" cy="6.400" r="1.500" />
      <circle cx="24.300" cy="9.200" r="1.400" />
    </svg>
  );
}
