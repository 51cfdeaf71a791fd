// What the user is told in passing.

export type Notice = {
  id: number;
  kind: 'info' | 'done' | 'warning';
  title: string;
  text?: string;
  code?: string;
};

let list = $state.raw<Notice[]>([]);
let next = 1;

/** Shows a notice: for some seconds, longer where there is more to read. The same one is not shown twice. */
export function notify(notice: Omit<Notice, 'id'>): void {
  const id = next++;
  list = [...list.filter((one) => one.title !== notice.title), { ...notice, id }].slice(-4);
  setTimeout(() => dismiss(id), notice.kind === 'warning' ? 9000 : 4000);
}

export function dismiss(id: number): void {
  list = list.filter((notice) => notice.id !== id);
}

export const notices = {
  get list() {
    return list;
  },
};
