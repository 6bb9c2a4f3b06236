// Whether the program is ready: the first start on a machine compiles the solver.

const AGAIN = 1000; // ms

/** Show a notice while the solver is being compiled. @param {(sentence: string) => void} notice */
export async function watchProgram(notice) {
  for (let said = false; ; said = true) {
    const ready = await isReady();
    if (ready) {
      if (said) notice("");
      return;
    }
    notice("The solver is being compiled, which takes half a minute the first time. The result will appear by itself.");
    await new Promise((done) => window.setTimeout(done, AGAIN));
  }
}

async function isReady() {
  try {
    const response = await fetch("status");
    return !response.ok || (await response.json()).ready !== false;
  } catch {
    return true; // no answer at all: the requests for solutions report that
  }
}
