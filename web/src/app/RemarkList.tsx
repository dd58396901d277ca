import { Icon } from "./icons";
import { dismiss, remarks } from "./remarks";

export function Remarks() {
  return (
    <div class="remarks" role="status">
      {remarks.value.map((remark) => (
        <div class="remark" key={remark.text}>
          <p>{remark.text}</p>
          {remark.action && (
            <button type="button" class="button" onClick={remark.action.act}>
              {remark.action.name}
            </button>
          )}
          <button
            type="button"
            class="button plain icon-only"
            aria-label="Dismiss"
            onClick={() => dismiss(remark)}
          >
            <Icon name="close" />
          </button>
        </div>
      ))}
    </div>
  );
}
