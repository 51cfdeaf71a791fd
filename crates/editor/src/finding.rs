//! What is wrong with a form, told of the field at fault.

use ferrocut_machine::{Alarm, Argument, Catalogue, Fault, Language};
use ferrocut_program::Span;
use serde::Serialize;

/// A finding as a form shows it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Finding {
    /// The field: the name of a value, `positions.N`, `profile`; empty where it is of the cycle as a whole.
    pub parameter: String,
    /// The alarm, `FC-0302`.
    pub id: String,
    /// `error` or `warning`.
    #[cfg_attr(feature = "typescript", ts(type = "'error' | 'warning'"))]
    pub severity: &'static str,
    /// What is wrong.
    pub text: String,
    /// What to do; empty where nothing is known.
    pub help: String,
}

/// A fault of a field.
#[derive(Clone, PartialEq, Debug)]
pub struct Wrong {
    /// The field.
    pub parameter: String,
    /// What is wrong.
    pub alarm: Alarm,
}

impl Wrong {
    /// A fault of a field.
    pub fn new(fault: Fault, parameter: impl Into<String>) -> Wrong {
        let parameter = parameter.into();
        let alarm = Alarm::core(fault, Span::default());
        let alarm = if parameter.is_empty() { alarm } else { alarm.with("parameter", parameter.as_str()) };
        Wrong { parameter, alarm }
    }

    /// The same with a value for its text.
    pub fn with(mut self, name: &'static str, value: impl Into<Argument>) -> Wrong {
        self.alarm.arguments.push((name, value.into()));
        self
    }

    /// An alarm of the interpreter, which names the parameter as blocks do: `#ROUGH step`.
    pub fn of(alarm: Alarm) -> Wrong {
        let named = alarm.arguments.iter().find(|(name, _)| *name == "parameter");
        let parameter = match named {
            Some((_, Argument::Text(text))) => field_of(text),
            _ => String::new(),
        };
        Wrong { parameter, alarm }
    }

    /// Whether it keeps the cycle from being written.
    pub fn is_error(&self) -> bool {
        self.alarm.severity == ferrocut_machine::Severity::Error
    }

    /// As a form shows it.
    pub fn finding(&self, language: Language) -> Finding {
        let catalogue = Catalogue::new(language);
        Finding {
            parameter: self.parameter.clone(),
            id: self.alarm.id.to_string(),
            severity: self.alarm.severity.name(),
            text: catalogue.message(&self.alarm),
            help: catalogue.help(&self.alarm).unwrap_or_default(),
        }
    }
}

/// The field of a parameter as the interpreter names it.
fn field_of(parameter: &str) -> String {
    let Some((directive, name)) = parameter.split_once(' ') else { return parameter.to_owned() };
    match directive {
        "#DRILL" => format!("drill.{name}"),
        "#ROUGH" => format!("rough.{name}"),
        "#SEMI" => format!("semi.{name}"),
        "#FINISH" => format!("finish.{name}"),
        "#MULTI" => format!("positions.{name}"),
        _ => name.to_owned(),
    }
}
