// Every page of the panel with its tabs.
export const pages = {
  position: ['relative', 'absolute', 'all', 'program'],
  program: ['run', 'edit', 'mdi', 'directory', 'dnc'],
  offsets: ['tools', 'parameters', 'variables', 'pitch'],
  settings: ['zeros', 'centring', 'probe', 'tool', 'machine_zero', 'general', 'data', 'rights'],
  graphics: [],
  cycles: [],
  diagnosis: ['signals', 'bytes', 'waveform', 'timing'],
  plc: ['monitor', 'data', 'edit', 'trace', 'info'],
  alarms: ['active', 'history', 'log'],
  help: ['search', 'operations', 'codes', 'parameters', 'alarms', 'variables', 'addresses', 'calculator'],
} as const;
