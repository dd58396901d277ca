import { dismissToast, toasts } from "../store/toasts";
import { Icon } from "../ui/icons";

/** Messages that do not interrupt the user. */
export function Toasts() {
  return (
    <div class="toasts" role="status">
      {toasts.value.map((toast) => (
        <div class="toast" key={toast.text}>
          <p>{toast.text}</p>
          {toast.action && (
            <button type="button" class="button" onClick={toast.action.run}>
              {toast.action.name}
            </button>
          )}
          <button
            type="button"
            class="button flat icon-only"
            aria-label="Dismiss"
            onClick={() => dismissToast(toast)}
          >
            <Icon name="close" />
          </button>
        </div>
      ))}
    </div>
  );
}
