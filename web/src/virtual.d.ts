declare module "virtual:player" {
  /** The address of the page in one file that has its blocks empty. */
  const address: string;
  export default address;
}
