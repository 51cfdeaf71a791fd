export { Fn as createAttachmentKey, In as fromAction } from "./shared/index-client.js";
