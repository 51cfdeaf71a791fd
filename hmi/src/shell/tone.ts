import type { Activity } from '$lib/api/types';

/** What a state of the machine means to who looks at it: it runs, waits for somebody, is in danger, is moved by hand. */
export function tone(activity: Activity): 'run' | 'wait' | 'bad' | 'hand' | 'idle' {
  switch (activity) {
    case 'running':
      return 'run';
    case 'held':
    case 'stopped':
    case 'block_end':
      return 'wait';
    case 'alarm':
    case 'emergency':
      return 'bad';
    case 'by_hand':
    case 'returning':
    case 'resetting':
      return 'hand';
    default:
      return 'idle';
  }
}
