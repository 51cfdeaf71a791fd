// What is asked again and again while somebody looks at it.
import { machine } from './machine.svelte';

/** Asks until the answer is called: one question after the other, so that a slow connection is asked less often. `wanted` says
    whether an answer is still of use. */
export function again(pause: number, ask: (wanted: () => boolean) => Promise<void>): () => void {
  let goesOn = true;
  const wanted = () => goesOn;
  const go = async () => {
    while (goesOn) {
      if (document.visibilityState === 'visible' && machine.link === 'open') await ask(wanted);
      await new Promise((resolve) => setTimeout(resolve, pause));
    }
  };
  void go();
  return () => {
    goesOn = false;
  };
}

/** Tells the values of signals, by name or address. */
export function followSignals(names: string[], pause: number, told: (values: Record<string, number>) => void): () => void {
  return again(pause, async (wanted) => {
    if (!names.length) return;
    const reply = await machine.ask({ do: 'signals', names }).catch(() => null);
    if (wanted() && reply?.reply === 'signals') told(reply.signals);
  });
}
