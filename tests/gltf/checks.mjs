// Counts what holds and says what does not.

export class Checks {
  passed = 0;
  failed = 0;

  /** One thing that must hold. `fault` is "" or says what is wrong. */
  add(name, fault) {
    if (fault) {
      this.failed += 1;
      console.log(`FAILED ${name}: ${fault}`);
    } else {
      this.passed += 1;
    }
  }

  /** The last line of the output, and the exit code. */
  finish() {
    console.log(`${this.passed} passed, ${this.failed} failed`);
    process.exitCode = this.failed === 0 && this.passed > 0 ? 0 : 1;
  }
}
