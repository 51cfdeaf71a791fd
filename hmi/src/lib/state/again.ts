// What is asked again and again while somebody looks at it, or whenever it changes.
import { Refused } from '$lib/api/socket';
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

/** Tells what parameters are, by name; for an effect, which asks again whenever some change. Nothing is told of those that the
    control does not have, and nothing at all where the connection is lost before the answer. */
export function followParameters(names: string[], told: (values: Record<string, number>) => void): () => void {
  let wanted = true;
  void machine.changed('parameters');
  if (machine.link === 'open') {
    machine.ask({ do: 'parameters', names }).then(
      (reply) => wanted && told(reply.reply === 'parameters' ? reply.parameters : {}),
      // A control that has not even one of them refuses.
      (failed) => wanted && !(failed instanceof Refused && failed.code === 'no_connection') && told({}),
    );
  }
  return () => {
    wanted = false;
  };
}
