import { dismissToast, toasts } from "../store/toasts";
import { Icon } from "../ui/icons";

export function Toasts() {
  return (
    <div class="remarks" role="status">
      {toasts.value.map((remark) => (
        <div class="remark" key={remark.text}>
          <p>{remark.text}</p>
          {remark.action && (
            <button type="button" class="button" onClick={remark.action.run}>
              {remark.action.name}
            </button>
          )}
          <button
            type="button"
            class="button flat icon-only"
            aria-label="Dismiss"
            onClick={() => dismissToast(remark)}
          >
            <Icon name="close" />
          </button>
        </div>
      ))}
    </div>
  );
}
