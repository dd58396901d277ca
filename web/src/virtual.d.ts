declare module "virtual:player" {
  /** URL of the player: the app as a single HTML file with empty blocks. */
  const playerUrl: string;
  export default playerUrl;
}
