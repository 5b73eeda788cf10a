/** Nobody answered: the server is down, or the network is. */
export class ServiceAway extends Error {
  constructor(options?: ErrorOptions) {
    super("the service does not answer", options);
    this.name = "ServiceAway";
  }
}
